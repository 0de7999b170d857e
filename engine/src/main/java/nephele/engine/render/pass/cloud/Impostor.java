package nephele.engine.render.pass.cloud;

import java.util.function.Supplier;
import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.cloud.drawn.PuffSlabs;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.scene.View;

/** The impostor of one cloud of balls: the picture that is shown, and the one that is made meanwhile. */
final class Impostor implements GlObject {
    /** Wear from which on a new picture is made. */
    private static final double WORN = 0.75;
    /** Frames in which a picture wears, for each in which it is made; others are made meanwhile. */
    private static final double LEAST_LIFE = 1.5;
    /** Frames in which a picture wears, for each in whose time its balls could be drawn. */
    private static final double LEAST_USE = 1.5;
    /** Frames after which a cloud that is not worth a picture is asked again. */
    private static final int PAUSE_FRAMES = 8;

    private final PlacedCloud placed;
    private final LitCloud cells;
    private final PerPixels<PuffProgram> programs;
    private final Supplier<CloudPuffs> balls;
    private ImpostorPicture shown;
    private ImpostorPicture coming;
    private Aabb bounds;
    private CloudPuffs boundedFrom;
    private CloudPuffs boundedTo;
    private DrawnCloud shownBefore;
    private double shareBefore;
    private double ageing;
    private int pause;
    private double wear;
    /** Frames that the last picture took or would have taken. */
    private double makingFrames;

    /** @param balls of the frame */
    Impostor(
            GlContext gl,
            PlacedCloud placed,
            LitCloud cells,
            PerPixels<PuffProgram> programs,
            Supplier<CloudPuffs> balls) {
        this.balls = balls;
        this.placed = placed;
        this.cells = cells;
        this.programs = programs;
        shown = new ImpostorPicture(gl);
        coming = new ImpostorPicture(gl);
    }

    /** Forgets its pictures. */
    void forget() {
        shown.forget();
        coming.forget();
        pause = 0;
    }

    /** Takes the balls at the two times between which the frame is. */
    void follow(CloudPuffs from, CloudPuffs to) {
        if (from != boundedFrom || to != boundedTo) {
            boundedFrom = from;
            boundedTo = to;
            bounds = bounds(from).union(to == from ? Aabb.EMPTY : bounds(to));
        }
        ageing = ImpostorPicture.ageing(cells, shownBefore, shareBefore);
        shownBefore = cells.shown();
        shareBefore = cells.share();
    }

    private static Aabb bounds(CloudPuffs balls) {
        Aabb all = Aabb.EMPTY;
        for (CloudPuffs.Puff ball : balls.all()) {
            double side = 2 * ball.radiusMetres();
            all = side > 0 ? all.union(Aabb.around(ball.centre(), new Vec3(side, side, side))) : all;
        }
        return all;
    }

    /** Returns the bounds of its balls at the time of the frame. */
    Aabb bounds() {
        return bounds.moved(placed.drift());
    }

    PlacedCloud placed() {
        return placed;
    }

    LitCloud cells() {
        return cells;
    }

    PuffProgram captureProgram() {
        return programs.of(CloudPixels.CAPTURED);
    }

    ImpostorPicture shown() {
        return shown;
    }

    ImpostorPicture coming() {
        return coming;
    }

    /**
     * Begins a new picture if the one that is shown is worn and another one is worth its making.
     *
     * @param moved the eye's way of the last frame
     */
    void prepare(View view, Vec3 moved, ImpostorLimits limits) {
        wear = wear(shown, view, limits);
        if (coming.slabs() != null && wear(coming, view, limits) > WORN) {
            coming.forget();
            pause = PAUSE_FRAMES;
        }
        pause = Math.max(0, pause - 1);
        if (wear <= WORN || pause > 0 || coming.slabs() != null || placed.presence() == 0) {
            return;
        }
        PuffSlabs slabs =
                PuffSlabs.of(balls.get(), eye(view), limits.texel(view)).orElse(null);
        if (slabs != null && isWorth(slabs, view, moved, limits)) {
            coming.begin(slabs, placed, cells);
        } else {
            pause = PAUSE_FRAMES;
        }
    }

    private boolean isWorth(PuffSlabs slabs, View view, Vec3 moved, ImpostorLimits limits) {
        Vec3 next = slabs.eye().plus(moved);
        double turned = Math.max(slabs.errorRadians(next) / limits.toleranceRadians(view), slabs.otherError(next));
        double step = Math.max(turned, ageing);
        long texels = slabs.texels();
        makingFrames = Math.ceil((double) texels / ImpostorLimits.MOST_TEXELS);
        double drawingFrames = texels / limits.texelsDirectly(slabs, view);
        for (int ball = 0; ball < slabs.balls().size(); ball++) {
            if (slabs.texels(ball) > ImpostorLimits.MOST_TEXELS) {
                return false;
            }
        }
        return WORN / step >= Math.max(LEAST_LIFE * makingFrames, LEAST_USE * drawingFrames);
    }

    /** Returns how much needs to be done, 0 if nothing does. */
    double need() {
        return coming.slabs() == null ? 0 : wear;
    }

    /** Shows the picture that has become complete. */
    void change() {
        ImpostorPicture before = shown;
        shown = coming;
        coming = before;
        coming.forget();
    }

    /** Returns true if a canvas can show the picture in the place of the balls. */
    boolean serves(View view, ImpostorLimits limits) {
        return shown.slabs() != null && wear(shown, view, limits) <= 1;
    }

    private double wear(ImpostorPicture picture, View view, ImpostorLimits limits) {
        return picture.slabs() == null
                ? Double.POSITIVE_INFINITY
                : picture.wear(eye(view), limits.toleranceRadians(view), placed, cells);
    }

    private Vec3 eye(View view) {
        return view.eye().minus(placed.drift());
    }

    @Override
    public void close() {
        shown.close();
        coming.close();
    }
}
