// Returns a value if all of it are finite numbers, or another one. Compilers may turn comparisons around as if nothing were
// undefined, so the bits decide: all of the exponent's are set in infinity and in what is no number.
vec4 finite(vec4 value, vec4 otherwise) {
    const uint EXPONENT = 0x7f800000u;
    uvec4 exponents = floatBitsToUint(value) & EXPONENT;
    return any(equal(exponents, uvec4(EXPONENT))) ? otherwise : value;
}
