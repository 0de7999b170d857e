package nephele.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class PicturePolygonTest {
    private static PicturePolygon of(double... corners) {
        var polygon = new PicturePolygon();
        for (int i = 0; i < corners.length; i += 2) {
            polygon.add(3 * corners[i], 3 * corners[i + 1], 3);
        }
        return polygon;
    }

    @Test
    void whatIsSeenThroughAnotherIsTheirIntersection() {
        var seen = of(-0.25, -0.75, 0.75, -0.75, 0.75, 0.75, -0.25, 0.75);
        seen.keepWithin(of(-0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5));
        assertEquals(0.75 / 4, seen.fraction(), 1e-15);
    }

    /** Clipping may leave two corners that should be equal, the second slightly before the first. */
    @Test
    void cornersThatRoundingPartsDoNotCutEverything() {
        var seen = of(-0.25, -0.75, 0.75, -0.75, 0.75, 0.75, -0.25, 0.75);
        double before = Math.nextDown(-0.5);
        seen.keepWithin(of(-0.5, -0.5, 0.5, -0.5, 0.5, before, 0.5, 0.5, -0.5, 0.5));
        assertEquals(0.75 / 4, seen.fraction(), 1e-15);
    }
}
