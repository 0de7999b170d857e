// With several samples a pixel, a shader runs at the pixel's centre, which may lie outside the face that covers some of the
// samples: there a position may be inside a wall, in whose shadow the face would be. These functions move a value to the
// middle of the covered samples. OpenGL's centroid interpolation is for that, but Mesa's llvmpipe 22.3 interpolates wrong
// values at it and at samples.

// Returns the offset from the pixel's centre to the middle of the covered samples, pixels.
vec2 coveredOffset() {
#ifdef MULTISAMPLED
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 8; i++) {  // drivers may draw more samples than were requested; others cover nothing
        vec2 position = i % 2 == 0 ? samplePositions[i / 2].xy : samplePositions[i / 2].zw;
        sum += vec3(position, 1.0) * float(gl_SampleMaskIn[0] >> i & 1);
    }
    return sum.xy / max(sum.z, 1.0);
#else
    return vec2(0.0);
#endif
}

vec3 atCovered(vec3 atCentre, vec2 offset) {
#ifdef MULTISAMPLED
    return atCentre + offset.x * dFdx(atCentre) + offset.y * dFdy(atCentre);
#else
    return atCentre;
#endif
}
