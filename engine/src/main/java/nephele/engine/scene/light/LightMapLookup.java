package nephele.engine.scene.light;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.FaceFragment;
import nephele.engine.scene.light.bake.FaceFragments;
import nephele.engine.scene.light.bake.LightMapChart;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.PolygonClipping;
import nephele.engine.scene.light.bake.SkyVisibility;

/**
 * The light map coordinates of face fragments: in each fragment's own chart if the map was baked for these solids.
 * Edited solids keep the old light until the next bake: a fragment uses the nearest chart of its face, found by its
 * solid's id and the face's name, and moves along with its solid; new faces are bright, or without a sky like their neighbours.
 */
public final class LightMapLookup {
    /** The least cosine between the normals of faces that look the same way. */
    private static final double LEAST_LIKENESS = 0.7;

    /** More than any distance to a face that looks the same way. */
    private static final double FARTHER_METRES = 1e9;

    private final SkyVisibility baked;
    private final List<Brush> solids;
    private final boolean isOwn;
    private final Map<String, Integer> bakedById;
    private Spot brightest;

    /**
     * Makes the lookup.
     *
     * @param baked for these solids or for those before an edit
     */
    public LightMapLookup(SkyVisibility baked, List<Brush> solids) {
        this(baked, solids, new HashMap<>());
        for (int i = 0; i < baked.statics().solids().size(); i++) {
            bakedById.putIfAbsent(baked.statics().solids().get(i).solidId(), i);
        }
    }

    private LightMapLookup(SkyVisibility baked, List<Brush> solids, Map<String, Integer> bakedById) {
        this.baked = baked;
        this.solids = solids;
        this.bakedById = bakedById;
        isOwn = baked.isOf(solids);
    }

    /** Returns the lookup of the same light for other solids. */
    public LightMapLookup edited(List<Brush> others) {
        return new LightMapLookup(baked, others, bakedById);
    }

    /**
     * The texel coordinates of the points of one fragment.
     *
     * @param chart {@code null} if all points have the same coordinates
     * @param column of the chart's first texel centre, from the map's left border; {@code row} from its lower border
     * @param from displacement of the solid since the bake, metres
     */
    public record Spot(LightMapChart chart, double column, double row, Vec3 from) {
        /** For fragments covered by another solid. */
        private static final Spot COVERED = new Spot(null, 0.5, 0.5, Vec3.ZERO);

        public double columnOf(Vec3 p) {
            return chart == null ? column : column + chart.columnOf(relative(p));
        }

        public double rowOf(Vec3 p) {
            return chart == null ? row : row + chart.rowOf(relative(p));
        }

        private Vec3 relative(Vec3 p) {
            return p.minus(from);
        }
    }

    /**
     * Returns the light map coordinates of one fragment.
     *
     * @param solid index of its solid
     * @param part its index among those of its face
     */
    public Spot of(int solid, int face, int part, FaceFragment fragment) {
        if (fragment.isCovered()) {
            return Spot.COVERED;
        }
        if (isOwn) {
            return spot(baked.layout().chartOf().get(solid).get(face)[part], Vec3.ZERO);
        }
        Brush brush = solids.get(solid);
        Integer old = bakedById.get(brush.solidId());
        int oldFace = old == null
                ? -1
                : faceNamed(
                        baked.statics().solids().get(old),
                        brush.faces().get(face).name());
        if (oldFace < 0) {
            return ofNew(brush.faces().get(face), fragment);
        }
        Vec3 moved = moved(
                baked.statics().solids().get(old).shape().bounds(),
                brush.shape().bounds());
        int chart = nearest(baked.layout().chartOf().get(old).get(oldFace), fragment, moved);
        return chart < 0 ? ofNew(brush.faces().get(face), fragment) : spot(chart, moved);
    }

    private static int faceNamed(Brush brush, String name) {
        for (int face = 0; face < brush.faces().size(); face++) {
            if (brush.faces().get(face).name().equals(name)) {
                return face;
            }
        }
        return -1;
    }

    /** Returns the displacement of a solid; zero if its size has changed, because then only a border was moved. */
    private static Vec3 moved(Aabb before, Aabb now) {
        Vec3 some = new Vec3(now.minX() - before.minX(), now.minY() - before.minY(), now.minZ() - before.minZ());
        Vec3 other = new Vec3(now.maxX() - before.maxX(), now.maxY() - before.maxY(), now.maxZ() - before.maxZ());
        return some.toVector().distance(other.x(), other.y(), other.z()) < FaceFragments.WELD_METRES ? some : Vec3.ZERO;
    }

    /** Returns the chart nearest to a fragment's centre, preferably one with the same outline; −1 if there is none. */
    private int nearest(int[] charts, FaceFragment fragment, Vec3 moved) {
        Vec3 middle = PolygonClipping.centroid(fragment.outline());
        Vec3 place = middle.minus(moved);
        int nearest = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int chart : charts) {
            if (chart >= 0) {
                LightMapChart candidate = baked.layout().charts().get(chart);
                boolean isSame = candidate.outline().equals(fragment.outline());
                double distance = isSame ? -1 : candidate.metresTo(place);
                if (distance < least) {
                    least = distance;
                    nearest = chart;
                }
            }
        }
        return nearest;
    }

    /** Returns the brightest texel; without a sky, which none is, that of the nearest face that looks the same way. */
    private Spot ofNew(BrushFace face, FaceFragment fragment) {
        List<LightMapChart> charts = baked.layout().charts();
        int[] texel = baked.brightest();
        if (charts.isEmpty() || baked.at(texel[0] + 0.5, texel[1] + 0.5) > 0) {
            return brightest();
        }
        Vec3 middle = PolygonClipping.centroid(fragment.outline());
        Vec3 normal = face.plane().normal();
        int nearest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < charts.size(); i++) {
            LightMapChart chart = charts.get(i);
            double beside = chart.metresTo(middle);
            double before = middle.minus(chart.outline().get(0)).toVector().dot(chart.normal());
            boolean isAlike = chart.normal().dot(normal.toVector()) > LEAST_LIKENESS;
            double distance = Math.hypot(beside, before) + (isAlike ? 0 : FARTHER_METRES);
            if (distance < least) {
                least = distance;
                nearest = i;
            }
        }
        return spot(nearest, Vec3.ZERO);
    }

    private Spot spot(int chart, Vec3 moved) {
        LightMapLayout layout = baked.layout();
        return new Spot(layout.charts().get(chart), layout.columnOf()[chart] + 0.5, layout.rowOf()[chart] + 0.5, moved);
    }

    private Spot brightest() {
        if (brightest == null) {
            int[] texel = baked.brightest();
            brightest = new Spot(null, texel[0] + 0.5, texel[1] + 0.5, Vec3.ZERO);
        }
        return brightest;
    }
}
