package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Upright pictures of one kind, at places that the author lists or over a field. They are to be looked at: nothing that
 * is simulated depends on them.
 *
 * @param sprite asset id of the picture; with several frames, a row of equal pictures from left to right
 * @param colourKey colour of the picture, as stored, that is transparent; {@code null} for the alpha of the picture, or
 *     black if it has none
 * @param heightVariation share of the size by which the smallest one is smaller: sizes are random from 1 − this to 1
 * @param at the middles of the lower edges, in metres
 * @param field plants them instead; {@code null} for the listed places
 * @param framesPerSecond 0 for frames that stand still, one by random for each billboard
 * @param windMetresPerSecond how strongly they sway, towards +x
 * @param blended true for mist, smoke and fire; false for sprites with edges, which are drawn where half covered
 * @param emission light that they emit, as a factor on the picture's colours; for fire
 * @param colour instead of the picture's colours, linear; {@code null} for those
 */
public record Billboards(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(required = true, text = TextKind.ASSET, prototype = "\"textures/sprites/bush.png\"") String sprite,
        @Written @Range(min = 0, max = 1) Vec3 colourKey,
        @Written(absent = "\"cylindrical\"") Facing facing,
        @Written(required = true, array = true, prototype = "[1.4, 1.05]") Size sizeMetres,
        @Written @Range(min = 0, max = 1) double heightVariation,
        @Written(most = 100_000, spatial = Spatial.POINT) @Range List<Vec3> at,
        @Written Field field,
        @Written(absent = "1") @Range(min = 1, max = MOST_FRAMES) int frames,
        @Written @Range(min = 1e-3, max = 240, shape = Range.Shape.OR_ZERO) double framesPerSecond,
        @Written @Range(min = 0, max = 60) double windMetresPerSecond,
        @Written boolean blended,
        @Written(absent = "[0, 0, 0]") @Range(min = 0, max = 1e4) Vec3 emission,
        @Written @Range(min = 0, max = 1e4) Vec3 colour) {
    /** The most billboards of a level, fields included. */
    public static final int MOST = 200_000;

    public static final int MOST_FRAMES = 64;

    /** How a billboard is turned; its word in a level file is the name in lower case. */
    public enum Facing {
        /** Towards the eye, about its middle; its upper edge as high as it can be. */
        SPHERICAL,
        /** Upright, about its vertical axis towards the eye. */
        CYLINDRICAL,
        /** Parallel to the picture. */
        SCREEN,
        /** Two upright pictures at right angles that stand still. */
        CROSSED,
        /**
         * By the formula of the monograph on objects on terrain, atan((xe − xp) / (ze − zp)) about the vertical axis: it
         * faces away on half of the circle and has no angle at equal z.
         */
        SOURCE
    }

    /** Width and height of the largest one. */
    public record Size(
            @Written(required = true, spatial = Spatial.LENGTH) @Range(min = 0.01, max = 1000) double width,
            @Written(required = true, spatial = Spatial.LENGTH) @Range(min = 0.01, max = 1000) double height) {}

    /**
     * Random places that keep a distance.
     *
     * @param terrain on which they stand; {@code null} for the highest surfaces of everything
     * @param spacingMetres the least horizontal distance between two
     * @param densityMap a grey picture over the ground: white has most, black none; its left is at the least x, its top
     *     at the least z. {@code null} for an even field
     * @param maxSlopeDegrees of the ground below
     * @param heightRangeMetres of the ground below, above y = 0; {@code null} for all heights
     */
    public record Field(
            @Written(text = TextKind.ID, refersTo = "terrains") String terrain,
            @Written @Range(min = 0, max = 1e9) int seed,
            @Written(required = true, prototype = "20") @Range(min = 1, max = MOST) int count,
            @Written(required = true, spatial = Spatial.LENGTH, prototype = "1") @Range(min = 0.01, max = 1e4)
                    double spacingMetres,
            @Written(text = TextKind.ASSET) String densityMap,
            @Written(absent = "90") @Range(min = 0, max = 90) double maxSlopeDegrees,
            @Written(array = true) HeightLimits heightRangeMetres) {}

    /** The least and the greatest height. */
    public record HeightLimits(
            @Written(required = true, spatial = Spatial.LENGTH, prototype = "-1000") @Range double low,
            @Written(required = true, spatial = Spatial.LENGTH, prototype = "1000") @Range double high) {}

    /** Makes opaque billboards of one size that stand still at places. */
    public static Billboards at(String id, String sprite, Facing facing, double width, double height, List<Vec3> at) {
        return new Billboards(
                id, sprite, null, facing, new Size(width, height), 0, at, null, 1, 0, 0, false, Vec3.ZERO, null);
    }

    /** Returns these billboards without wind. */
    public Billboards withoutWind() {
        return RecordCopy.with(this, "windMetresPerSecond", 0.0);
    }

    /** Returns these billboards blended over what is behind them. */
    public Billboards asBlended() {
        return RecordCopy.with(this, "blended", true);
    }

    /** Returns these billboards with edges and, if it is not {@code null}, in one colour. */
    public Billboards withEdges(Vec3 oneColour) {
        Vec3 emitted = oneColour == null ? emission : Vec3.ZERO;
        return RecordCopy.with(this, "blended", false, "emission", emitted, "colour", oneColour);
    }

    /** Returns these billboards over a field instead of the listed places, and in wind. */
    public Billboards over(Field otherField, double variation, double wind) {
        return RecordCopy.with(
                this, "heightVariation", variation, "at", List.of(), "field", otherField, "windMetresPerSecond", wind);
    }

    /** Returns these billboards with other axes. */
    public Billboards turned(Facing other) {
        return RecordCopy.with(this, "facing", other);
    }

    /** Returns true if they sway or their picture changes. */
    public boolean moves() {
        return windMetresPerSecond > 0 || frames > 1 && framesPerSecond > 0;
    }

    /** Returns a box around the listed ones; empty for a field. */
    public Aabb listedBounds() {
        double width = sizeMetres.width();
        Vec3 up = new Vec3(0, sizeMetres.height() / 2, 0);
        return at.stream()
                .map(foot -> Aabb.around(foot.plus(up), new Vec3(width, sizeMetres.height(), width)))
                .reduce(Aabb.EMPTY, Aabb::union);
    }

    /** Returns the number of billboards that the author asks for. */
    public int count() {
        return field == null ? at.size() : field.count();
    }
}
