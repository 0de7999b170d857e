// The falloff of a punctual light. Twin: nephele.engine.level.appearance.PunctualLight.

// Returns the inverse square (1/m2) under a window that is zero at the range (Karis 2013); constant below 1 cm.
float windowedInverseSquare(float squareDistance, float inverseSquareRange) {
    float q = squareDistance * inverseSquareRange;
    float window = clamp(1.0 - q * q, 0.0, 1.0);
    return window * window / max(squareDistance, 1e-4);
}

// Returns 1 inside the inner cone, 0 outside the outer one; scale 0 and offset 1 for a light without a cone.
float coneFactor(float cosineFromAxis, float scale, float offset) {
    float t = clamp(cosineFromAxis * scale + offset, 0.0, 1.0);
    return t * t;
}
