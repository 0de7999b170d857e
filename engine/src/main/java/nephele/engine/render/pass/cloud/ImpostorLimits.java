package nephele.engine.render.pass.cloud;

import nephele.engine.cloud.drawn.CloudPuffs.Puff;
import nephele.engine.cloud.drawn.PuffSlabs;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;

/**
 * How good impostors must be in a picture, and how fast they are made.
 *
 * @param tolerancePixels by which a part of a cloud may be in a wrong place
 * @param pictureHeight pixels
 * @param divisor pixels along each side of one of the layer of clouds
 * @param side of the square of rays of that layer of which a frame draws one
 */
record ImpostorLimits(double tolerancePixels, int pictureHeight, int divisor, int side) {
    /** Texels that a frame draws at most for new pictures; balls that cover each other count each. */
    static final long MOST_TEXELS = 1 << 19;

    private static final double FINEST_TEXEL = 0.5;

    /** Returns the tolerance as an angle: pixels are narrowest in the corners of a picture. */
    double toleranceRadians(View view) {
        Projection projection = view.projection();
        double corner = 1
                + projection.tanHalfWidth() * projection.tanHalfWidth()
                + projection.tanHalfHeight() * projection.tanHalfHeight();
        return tolerancePixels * pixel(view) / corner;
    }

    /** Returns the width at distance 1 of the finest texel of use: a picture between whose texels is interpolated is less sharp. */
    double texel(View view) {
        return FINEST_TEXEL * divisor * pixel(view);
    }

    /** Returns the pixels that the balls are drawn into if a frame has no impostor of them. */
    double texelsDirectly(PuffSlabs slabs, View view) {
        double finest = side * divisor * pixel(view);
        double sum = 0;
        for (Puff puff : slabs.balls()) {
            double width =
                    2 * puff.radiusMetres() / (puff.centre().minus(slabs.eye()).length() * finest);
            sum += width * width;
        }
        return sum;
    }

    private double pixel(View view) {
        return 2 * view.projection().tanHalfHeight() / pictureHeight;
    }
}
