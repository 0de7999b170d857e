package nephele.engine.render.pass.cloud;

import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.cloud.drawn.PuffSlabs;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.scene.View;

/** The impostor of one cloud of puffs: the picture that is drawn, and the one that is made meanwhile. */
final class Impostor implements GlObject {
    /** Wear from which on a new picture is made. */
    private static final double WORN = 0.75;
    /** Frames in which a picture wears, for each in which it is made; others are made meanwhile. */
    private static final double LEAST_LIFE = 1.5;
    /** Frames in which a picture wears, for each in whose time its puffs could be drawn. */
    private static final double LEAST_USE = 1.5;
    /** Frames after which a cloud that is not worth a picture is asked again. */
    private static final int PAUSE_FRAMES = 8;

    private final PuffCloud cloud;
    private final PlacedCloud placed;
    private final LitCloud cells;
    private ImpostorPicture drawn;
    private ImpostorPicture coming;
    private Aabb bounds;
    private CloudPuffs boundedFrom;
    private CloudPuffs boundedTo;
    private DrawnCloud earlierBefore;
    private double fractionBefore;
    private double ageing;
    private int pause;
    private double wear;
    /** Frames that the last picture took or would have taken. */
    private double makingFrames;

    Impostor(GlContext gl, PuffCloud cloud) {
        this.cloud = cloud;
        placed = cloud.placed();
        cells = cloud.cells();
        drawn = new ImpostorPicture(gl);
        coming = new ImpostorPicture(gl);
    }

    /** Forgets its pictures. */
    void forget() {
        drawn.forget();
        coming.forget();
        pause = 0;
    }

    /** Takes the puffs at the two times between which the frame is. */
    void follow(CloudPuffs from, CloudPuffs to) {
        if (from != boundedFrom || to != boundedTo) {
            boundedFrom = from;
            boundedTo = to;
            bounds = bounds(from).union(to == from ? Aabb.EMPTY : bounds(to));
        }
        ageing = ImpostorPicture.ageing(cells, earlierBefore, fractionBefore);
        earlierBefore = cells.earlier();
        fractionBefore = cells.fraction();
    }

    private static Aabb bounds(CloudPuffs puffs) {
        Aabb all = Aabb.EMPTY;
        for (CloudPuffs.Puff puff : puffs.all()) {
            double side = 2 * puff.radiusMetres();
            all = side > 0 ? all.union(Aabb.around(puff.centre(), new Vec3(side, side, side))) : all;
        }
        return all;
    }

    /** Returns the bounds of its puffs at the time of the frame. */
    Aabb bounds() {
        return bounds.moved(placed.drift());
    }

    PlacedCloud placed() {
        return placed;
    }

    PuffCloud cloud() {
        return cloud;
    }

    ImpostorPicture drawn() {
        return drawn;
    }

    ImpostorPicture coming() {
        return coming;
    }

    /**
     * Begins a new picture if the one that is drawn is worn and another one is worth its making.
     *
     * @param moved the eye's displacement in the last frame
     */
    void prepare(View view, Vec3 moved, Impostors limits) {
        wear = wear(drawn, view, limits);
        if (coming.slabs() != null && wear(coming, view, limits) > WORN) {
            coming.forget();
            pause = PAUSE_FRAMES;
        }
        pause = Math.max(0, pause - 1);
        if (wear <= WORN || pause > 0 || coming.slabs() != null || placed.presence() == 0) {
            return;
        }
        PuffSlabs slabs =
                PuffSlabs.of(cloud.puffs(), eye(view), limits.texel(view)).orElse(null);
        if (slabs != null && isWorth(slabs, view, moved, limits)) {
            coming.begin(slabs, placed, cells);
        } else {
            pause = PAUSE_FRAMES;
        }
    }

    private boolean isWorth(PuffSlabs slabs, View view, Vec3 moved, Impostors limits) {
        Vec3 next = slabs.eye().plus(moved);
        double turned = Math.max(slabs.errorRadians(next) / limits.toleranceRadians(view), slabs.otherError(next));
        double step = Math.max(turned, ageing);
        long texels = slabs.texels();
        makingFrames = Math.ceil((double) texels / Impostors.MOST_TEXELS);
        double drawingFrames = texels / limits.texelsDirectly(slabs, view);
        for (int puff = 0; puff < slabs.puffs().size(); puff++) {
            if (slabs.texels(puff) > Impostors.MOST_TEXELS) {
                return false;
            }
        }
        return WORN / step >= Math.max(LEAST_LIFE * makingFrames, LEAST_USE * drawingFrames);
    }

    /** Returns how much needs to be done, 0 if nothing does. */
    double need() {
        return coming.slabs() == null ? 0 : wear;
    }

    /** Makes the picture that has become complete the one that is drawn. */
    void change() {
        ImpostorPicture before = drawn;
        drawn = coming;
        coming = before;
        coming.forget();
    }

    /** Returns true if the picture is right enough for a view to take the place of the puffs. */
    boolean serves(View view, Impostors limits) {
        return drawn.slabs() != null && wear(drawn, view, limits) <= 1;
    }

    private double wear(ImpostorPicture picture, View view, Impostors limits) {
        return picture.slabs() == null
                ? Double.POSITIVE_INFINITY
                : picture.wear(eye(view), limits.toleranceRadians(view), placed, cells);
    }

    private Vec3 eye(View view) {
        return view.eye().minus(placed.drift());
    }

    @Override
    public void close() {
        drawn.close();
        coming.close();
    }
}
