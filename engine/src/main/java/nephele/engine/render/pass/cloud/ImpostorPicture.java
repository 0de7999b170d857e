package nephele.engine.render.pass.cloud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.cloud.cells.CellMarch.OutsideOfCloud;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.cloud.drawn.PuffSlabs;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;

/**
 * A cloud of puffs as seen from an eye, a picture for each slab: premultiplied radiance without air, the fraction of light that
 * passes, coverage and distance. Balls can be added over several frames.
 */
final class ImpostorPicture implements GlObject {
    /** Fraction of the time between two samples of clouds after which a picture is old. */
    private static final double OLD_FRACTION = 1 / 8.0;
    /** A longer time between two frames is a jump. */
    private static final double JUMP_SECONDS = 1;
    /** Wear of a picture whose samples of clouds have been replaced. */
    private static final double REPLACED = 0.75;
    /** Change of the sun's direction, radians, and of light, as a fraction, after which a picture is old. */
    private static final double OLD_LIGHT = 0.01;
    /** Change of the extinction, as a fraction, likewise. */
    private static final double OLD_PRESENCE = 0.25;

    private final GlContext gl;
    private final PuffQuads quads;
    private final List<RenderTarget> targets = new ArrayList<>();
    private PuffSlabs slabs;
    private int drawn;
    private DrawnCloud from;
    private DrawnCloud to;
    private double fraction;
    private double seconds;
    private double presence;
    private OutsideOfCloud around;

    ImpostorPicture(GlContext gl) {
        this.gl = gl;
        quads = new PuffQuads(gl);
    }

    /** Begins the picture of a cloud, empty. */
    void begin(PuffSlabs newSlabs, PlacedCloud placed, LitCloud cells) {
        slabs = newSlabs;
        drawn = 0;
        from = cells.earlier();
        to = cells.later();
        fraction = cells.fraction();
        seconds = placed.seconds();
        presence = placed.presence();
        around = cells.around();
        quads.upload(slabs.puffs(), slabs.eye(), presence);
        int width = slabs.width();
        int height = slabs.height();
        if (!targets.isEmpty()
                && (targets.get(0).width() != width || targets.get(0).height() != height)) {
            closeTargets();
        }
        for (int slab = 0; slab < slabs.slabs().size(); slab++) {
            if (slab == targets.size()) {
                targets.add(
                        RenderTarget.pair(gl, "impostor", PixelFormat.RGBA16F, width, height, Sampling.LINEAR_CLAMP));
            }
        }
    }

    /** Makes it serve no longer. */
    void forget() {
        slabs = null;
    }

    /** Returns {@code null} if nothing was begun. */
    PuffSlabs slabs() {
        return slabs;
    }

    boolean isComplete() {
        return slabs != null && drawn == slabs.puffs().size();
    }

    /** Returns the number of the slab whose puffs are drawn next. */
    int nextSlab() {
        int slab = 0;
        while (drawn >= slabs.slabs().get(slab).end()) {
            slab++;
        }
        return slab;
    }

    /** Returns how many of the next puffs, all of one slab, fit into so many texels. */
    int fitting(long texels) {
        int end = slabs.slabs().get(nextSlab()).end();
        int next = drawn;
        long left = texels;
        while (next < end && slabs.texels(next) <= left) {
            left -= slabs.texels(next++);
        }
        return next - drawn;
    }

    /** Draws the next puffs by the program in use into the bound target; returns the texels. */
    long draw(int count) {
        quads.draw(drawn, count);
        long texels = 0;
        for (int puff = drawn; puff < drawn + count; puff++) {
            texels += slabs.texels(puff);
        }
        drawn += count;
        return texels;
    }

    /** Directs drawing to the picture of the next puffs, which is emptied before its first one. */
    void bindTarget() {
        int slab = nextSlab();
        if (drawn == slabs.slabs().get(slab).first()) {
            targets.get(slab).clear(0, 0, 0);
        } else {
            targets.get(slab).bind();
        }
    }

    void bindTextures(int slab) {
        targets.get(slab).colour().bind(TextureUnit.IMPOSTOR);
        targets.get(slab).second().bind(TextureUnit.IMPOSTOR_PLACES);
    }

    /** Returns the view in which it is drawn. */
    View view(PlacedCloud placed) {
        var projection =
                new Projection(2 * Math.atan(slabs.tanHalfHeight()), slabs.width() / (double) slabs.height(), 0.1, 1e6);
        Vec3 eye = slabs.eye().plus(placed.drift());
        return new View(
                eye, slabs.axes().right(), slabs.axes().up(), slabs.axes().back(), projection);
    }

    /** Returns the present extinction divided by that of the picture. */
    double presence(PlacedCloud placed) {
        return placed.presence() / presence;
    }

    /**
     * Returns how much is wrong, 1 for as much as may be.
     *
     * @param eye in the space of the puffs
     * @param toleranceRadians direction by which a part of the cloud may be wrong
     */
    double wear(Vec3 eye, double toleranceRadians, PlacedCloud placed, LitCloud cells) {
        double place = Math.max(slabs.errorRadians(eye) / toleranceRadians, slabs.otherError(eye));
        double light = around.difference(cells.around()) / OLD_LIGHT;
        double thinned = Math.abs(presence(placed) - 1) / OLD_PRESENCE;
        return Math.max(Math.max(place, light), Math.max(thinned, age(placed, cells)));
    }

    /** Returns how much older a picture is after the change from one frame to the next. */
    static double ageing(LitCloud cells, DrawnCloud earlierBefore, double fractionBefore) {
        return cells.earlier() == earlierBefore ? Math.abs(cells.fraction() - fractionBefore) / OLD_FRACTION : 0;
    }

    private double age(PlacedCloud placed, LitCloud cells) {
        if (cells.earlier() == from) {
            return Math.abs(cells.fraction() - fraction) / OLD_FRACTION;
        } else if (cells.earlier() == to) {
            return (1 - fraction + cells.fraction()) / OLD_FRACTION;
        }
        return Math.abs(placed.seconds() - seconds) > JUMP_SECONDS ? Double.POSITIVE_INFINITY : REPLACED;
    }

    private void closeTargets() {
        targets.forEach(RenderTarget::close);
        targets.clear();
    }

    @Override
    public void close() {
        closeTargets();
        quads.close();
    }
}
