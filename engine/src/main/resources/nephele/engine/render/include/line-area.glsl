// Twin: nephele.engine.render.pass.edge.LineArea.

// Returns the integral from 0 to x of a line that falls from height at 0 to 0 at middle.
float fallingArea(float x, float middle, float height) {
    float t = min(x, middle);
    return height * t * (1.0 - 0.5 * t / middle);
}

// Returns the part of a pixel that lies beyond the line: it starts `before` pixels before the pixel and ends `after` behind
// it, half a pixel off the edge towards the side where each end is crossed: 1 this one, -1 the other one, 0 neither.
float areaBeyond(float before, float after, float atStart, float atEnd) {
    float size = before + 1.0 + after;
    float middle = 0.5 * size;
    float startPart = fallingArea(before + 1.0, middle, 0.5 * atStart) - fallingArea(before, middle, 0.5 * atStart);
    float endPart = fallingArea(after + 1.0, middle, 0.5 * atEnd) - fallingArea(after, middle, 0.5 * atEnd);
    return max(startPart, 0.0) + max(endPart, 0.0);
}
