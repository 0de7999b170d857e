package nephele.engine.render.pass.cloud;

import nephele.engine.math.Vec3;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.scene.View;

/** What clouds are drawn on: a view, a layer of it, a picture that is kept, or that of an impostor. */
public final class CloudCanvas {
    /** {@code null} for a picture that is kept. */
    private final CloudRanges ranges;

    private final FrameLightning lightning;
    private CloudPixels pixels;
    private View view;
    private Vec3 focus;
    /** {@code null} for pixels of a view. */
    private RayGrid grid;

    /** @param lightning {@code null} for none */
    CloudCanvas(CloudRanges ranges, FrameLightning lightning) {
        this.ranges = ranges;
        this.lightning = lightning;
    }

    /**
     * Returns the canvas of a picture that is kept: its programs are those for {@link CloudPixels#BAKED}.
     *
     * @param focus around which layers are sampled finely
     */
    public static CloudCanvas baked(View view, Vec3 focus) {
        var canvas = new CloudCanvas(null, null);
        canvas.begin(CloudPixels.BAKED, view, focus, null);
        return canvas;
    }

    /** @param focusOfFrame around which layers are sampled finely */
    void begin(CloudPixels whichPixels, View ofView, Vec3 focusOfFrame, RayGrid ofGrid) {
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

    /** Returns by how much quads must be larger, as a share of their distance, since rays are not at the middles of pixels. */
    public double margin() {
        return grid == null ? 0 : grid.pixel() * view.projection().tanHalfHeight();
    }

    /** Sets the uniforms of a program in use. */
    public void put(PixelUniforms uniforms, PlacedCloud cloud) {
        if (grid != null) {
            grid.put(uniforms.rays());
        }
        if (uniforms.rays() != null && uniforms.rays().blown() != null) {
            Vec3 blown = cloud.blown(grid.secondsBefore());
            uniforms.rays().blown().set((float) blown.x(), (float) blown.y(), (float) blown.z());
        }
        if (uniforms.flash() != null) {
            uniforms.flash().put(lightning, view);
        }
        if (uniforms.boltFromEye() != null) {
            Vec3 from = lightning.lightning().bolt().origin().minus(view.eye());
            uniforms.boltFromEye().set((float) from.x(), (float) from.y(), (float) from.z());
        }
        if (uniforms.share() != null) {
            uniforms.share().set((float) cloud.shareDrawn());
        }
        if (uniforms.ranges() != null) {
            ranges.put(uniforms.ranges(), view);
        }
    }
}
