// How a light's light thins out. Twin: nephele.engine.level.appearance.LightFalloff.

// Inverse square (1/m2) under a window that reaches zero at the range (Karis 2013); nearer than 1 cm it grows no further.
float windowedInverseSquare(float squareDistance, float inverseSquareRange) {
    float q = squareDistance * inverseSquareRange;
    float window = clamp(1.0 - q * q, 0.0, 1.0);
    return window * window / max(squareDistance, 1e-4);
}

// 1 inside the inner cone, 0 outside the outer one; scale 0 and offset 1 for a light without a cone.
float coneFactor(float cosineFromAxis, float scale, float offset) {
    float t = clamp(cosineFromAxis * scale + offset, 0.0, 1.0);
    return t * t;
}
