; NumPy's PCG64 in WebAssembly, on NumPy's own state: {address of (state, increment), has_uint32, uinteger}.
; As in numpy/random/src/pcg64/pcg64.h; the two numbers of 128 bits are low and high halves of 64.

declare i64 @llvm.fshr.i64(i64, i64, i64)

define internal i64 @upper_half(i64 %a, i64 %b) alwaysinline {
  %a_low = and i64 %a, 4294967295
  %a_high = lshr i64 %a, 32
  %b_low = and i64 %b, 4294967295
  %b_high = lshr i64 %b, 32
  %low_low = mul i64 %a_low, %b_low
  %high_low = mul i64 %a_high, %b_low
  %low_high = mul i64 %a_low, %b_high
  %high_high = mul i64 %a_high, %b_high
  %carry = lshr i64 %low_low, 32
  %middle = add i64 %high_low, %carry
  %middle_low = and i64 %middle, 4294967295
  %middle_high = lshr i64 %middle, 32
  %other = add i64 %low_high, %middle_low
  %other_high = lshr i64 %other, 32
  %sum = add i64 %high_high, %middle_high
  %result = add i64 %sum, %other_high
  ret i64 %result
}

define internal i64 @pcg64_next_uint64(i64 %address) alwaysinline {
  %place = inttoptr i64 %address to ptr
  %state = load ptr, ptr %place
  %at_high = getelementptr i64, ptr %state, i32 1
  %at_increment_low = getelementptr i64, ptr %state, i32 2
  %at_increment_high = getelementptr i64, ptr %state, i32 3
  %low = load i64, ptr %state
  %high = load i64, ptr %at_high
  %increment_low = load i64, ptr %at_increment_low
  %increment_high = load i64, ptr %at_increment_high
  ; state = state * 47026247687942121848144207491837523525 + increment
  %product_low = mul i64 %low, 4865540595714422341
  %product_1 = call i64 @upper_half(i64 %low, i64 4865540595714422341)
  %product_2 = mul i64 %low, 2549297995355413924
  %product_3 = mul i64 %high, 4865540595714422341
  %sum = add i64 %product_1, %product_2
  %product_high = add i64 %sum, %product_3
  %new_low = add i64 %product_low, %increment_low
  %overflows = icmp ult i64 %new_low, %product_low
  %carry = zext i1 %overflows to i64
  %sum_high = add i64 %product_high, %increment_high
  %new_high = add i64 %sum_high, %carry
  store i64 %new_low, ptr %state
  store i64 %new_high, ptr %at_high
  ; the output is XSL-RR: both halves mixed, and rotated by the six highest bits
  %mixed = xor i64 %new_low, %new_high
  %turn = lshr i64 %new_high, 58
  %output = call i64 @llvm.fshr.i64(i64 %mixed, i64 %mixed, i64 %turn)
  ret i64 %output
}

define internal double @pcg64_next_double(i64 %address) alwaysinline {
  %bits = call i64 @pcg64_next_uint64(i64 %address)
  %upper = lshr i64 %bits, 11
  %whole = uitofp i64 %upper to double
  %share = fmul double %whole, 0x3CA0000000000000
  ret double %share
}

define internal i32 @pcg64_next_uint32(i64 %address) alwaysinline {
  %place = inttoptr i64 %address to ptr
  %at_kept = getelementptr i8, ptr %place, i32 4
  %at_half = getelementptr i8, ptr %place, i32 8
  %kept = load i32, ptr %at_kept
  %has_half = icmp ne i32 %kept, 0
  br i1 %has_half, label %second, label %first
second:
  store i32 0, ptr %at_kept
  %half = load i32, ptr %at_half
  ret i32 %half
first:
  %bits = call i64 @pcg64_next_uint64(i64 %address)
  %upper = lshr i64 %bits, 32
  %upper_half_of_it = trunc i64 %upper to i32
  store i32 1, ptr %at_kept
  store i32 %upper_half_of_it, ptr %at_half
  %lower = trunc i64 %bits to i32
  ret i32 %lower
}

; Loops ask from time to time whether to end. Here they never do: a page ends a worker.
define internal i8 @asked_to_stop(i64 %line) alwaysinline {
  ret i8 0
}
