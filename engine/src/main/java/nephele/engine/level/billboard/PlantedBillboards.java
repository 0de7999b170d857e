package nephele.engine.level.billboard;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.SeededNoise;
import nephele.engine.math.Vec3;

/**
 * The billboards of a level at their places, those of fields included.
 *
 * @param groups in the order of the level
 */
public record PlantedBillboards(List<Group> groups) {
    /** How round a billboard is lit: a corner faces so far to the side and above. */
    public static final double BULGE = 0.75;

    /** Part of the light that leaves let through. */
    public static final double THROUGH = 0.4;

    /** Part of the sun's light that leaves which lie behind others receive on the mean. */
    public static final double BETWEEN_LEAVES = 0.75;

    private static final int SIZE = 0;
    private static final int PHASE = 1;
    private static final int TURN = 2;

    public PlantedBillboards {
        groups = List.copyOf(groups);
    }

    /**
     * The billboards of one record of the level.
     *
     * @param feet the middles of their lower edges
     */
    public record Group(Billboards authored, List<Vec3> feet) {
        public Group {
            feet = List.copyOf(feet);
        }

        /** Returns the size of a billboard as a share of the largest one's. */
        public double scale(int index) {
            return 1 - authored.heightVariation() * random(index, SIZE);
        }

        /** Returns a random part of a turn or of a round of frames, in [0, 1). */
        public double phase(int index) {
            return random(index, PHASE);
        }

        /** Returns the turn about the vertical axis of a crossed one, radians. */
        public double turn(int index) {
            return random(index, TURN) * StrictMath.PI;
        }

        private double random(int index, int purpose) {
            return new SeededNoise(authored.id().hashCode()).unit(index, purpose, 0);
        }

        /** Returns a box that holds a billboard however it is turned and swayed. */
        public Aabb bounds(int index) {
            double scale = scale(index);
            double width = authored.sizeMetres().width() * scale;
            double height = authored.sizeMetres().height() * scale;
            double reach = Math.hypot(width, height) / 2 + height * Sway.most(authored.windMetresPerSecond());
            Vec3 middle = feet.get(index).plus(new Vec3(0, height / 2, 0));
            return Aabb.around(middle, new Vec3(2 * reach, 2 * reach, 2 * reach));
        }
    }

    /** Returns corners between which all billboards with edges are, without planting them. */
    public static List<Vec3> reach(Level level, StaticShapes statics) {
        List<Vec3> corners = new ArrayList<>();
        for (Billboards authored : level.billboards()) {
            if (!authored.blended()) {
                double reach = Math.hypot(
                        authored.sizeMetres().width(), authored.sizeMetres().height());
                Aabb box = authored.field() == null ? authored.listedBounds() : statics.bounds();
                addCorners(box.grown(reach), corners);
            }
        }
        return corners;
    }

    private static void addCorners(Aabb box, List<Vec3> corners) {
        for (int i = 0; i < 8 && !box.isEmpty(); i++) {
            corners.add(box.corner(i));
        }
    }

    /**
     * Plants the billboards of a level.
     *
     * @throws nephele.engine.asset.AssetException that names a density map that cannot be used
     */
    public static PlantedBillboards of(Level level, StaticShapes statics, AssetSource assets) {
        List<Group> groups = new ArrayList<>();
        var planting = new FieldPlanting(statics);
        for (Billboards authored : level.billboards()) {
            List<Vec3> feet = authored.field() == null ? authored.at() : planting.plant(authored.field(), assets);
            groups.add(new Group(authored, feet));
        }
        return new PlantedBillboards(groups);
    }
}
