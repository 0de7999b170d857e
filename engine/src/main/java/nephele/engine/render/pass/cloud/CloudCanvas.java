package nephele.engine.render.pass.cloud;

import nephele.engine.lightning.Bolt;
import nephele.engine.math.Vec3;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.scene.View;

/** What clouds are drawn on: a view, a layer of it, a picture that is kept, or that of an impostor. */
public final class CloudCanvas {
    /** Places on the main channel of a bolt from which it lights clouds; it is brightest where it is in the cloud. */
    private static final double[] ALONG_BOLT = {0, 0.12, 0.28, 0.55};

    private static final double[] WEIGHT_OF_LIGHT = {0.4, 0.28, 0.2, 0.12};

    static final int FLASH_LIGHTS = ALONG_BOLT.length;

    private final FrameLightning lightning;
    private CloudPixels pixels;
    private View view;
    private Vec3 focus;
    /** {@code null} for pixels of a view. */
    private Grid grid;

    /**
     * Rays through clouds that are drawn at the pixels of a target of their own, as if there were no surfaces.
     *
     * @param side of the square of rays of which one is drawn, a power of 2
     * @param offsetX from the square's middle to that ray, rays; {@code offsetY} likewise
     * @param stepX from ray to ray, the view being 2 wide; {@code stepY} likewise
     * @param planeMetres distance of an impostor's picture along the view's axis; 0 for a layer
     * @param secondsBefore time of the rays that were drawn before; the present one if there are none
     */
    record Grid(
            int side,
            double offsetX,
            double offsetY,
            double stepX,
            double stepY,
            double planeMetres,
            double secondsBefore) {}

    /** @param lightning {@code null} for none */
    CloudCanvas(FrameLightning lightning) {
        this.lightning = lightning;
    }

    /**
     * Returns the canvas of a picture that is kept: its programs are those for {@link CloudPixels#BAKED}.
     *
     * @param focus around which layers are sampled finely
     */
    public static CloudCanvas baked(View view, Vec3 focus) {
        var canvas = new CloudCanvas(null);
        canvas.begin(CloudPixels.BAKED, view, focus, null);
        return canvas;
    }

    /** @param focusOfFrame around which layers are sampled finely */
    void begin(CloudPixels whichPixels, View ofView, Vec3 focusOfFrame, Grid ofGrid) {
        pixels = whichPixels;
        view = ofView;
        focus = focusOfFrame;
        grid = ofGrid;
    }

    public CloudPixels pixels() {
        return pixels;
    }

    public View view() {
        return view;
    }

    /** Returns the place around which layers are sampled finely. */
    public Vec3 focus() {
        return focus;
    }

    /**
     * Returns by how much quads must be larger, as a fraction of their distance, since rays are not at the middles of
     * pixels.
     */
    public double margin() {
        return grid == null ? 0 : grid.side * grid.stepY * view.projection().tanHalfHeight();
    }

    /** Sets the uniforms of a program in use. */
    public void put(CloudPrograms.Shared uniforms, PlacedCloud cloud) {
        if (grid != null) {
            uniforms.layerStep().set(grid.stepX, grid.stepY);
            uniforms.marchedSquare().set(grid.side, grid.offsetX, grid.offsetY);
            uniforms.capturedPlane().set(grid.planeMetres);
            uniforms.blown().set(cloud.blown(grid.secondsBefore));
        }
        uniforms.cut().set(is(CloudPixels.BEFORE_NEAREST), is(CloudPixels.BEFORE_FARTHEST), is(CloudPixels.BEFORE_OWN));
        uniforms.cloudFraction().set(cloud.fractionDrawn());
        if (pixels == CloudPixels.BOLT) {
            uniforms.boltFromEye().set(boltFromEye());
        } else if (pixels == CloudPixels.FLASH) {
            Vec3 from = boltFromEye();
            Bolt bolt = lightning.lightning().bolt();
            for (int i = 0; i < FLASH_LIGHTS; i++) {
                uniforms.flashLights().get(i).set(from.plus(bolt.along(ALONG_BOLT[i])), WEIGHT_OF_LIGHT[i]);
            }
            uniforms.flashIntensity().set(lightning.radiantIntensity());
        }
    }

    private double is(CloudPixels which) {
        return pixels == which ? 1 : 0;
    }

    private Vec3 boltFromEye() {
        return lightning.lightning().bolt().origin().minus(view.eye());
    }
}
