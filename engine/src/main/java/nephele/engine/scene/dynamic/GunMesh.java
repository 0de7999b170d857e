package nephele.engine.scene.dynamic;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.List;
import nephele.engine.level.Material;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials.Slot;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.dynamic.DynamicMesh.Builder;
import nephele.engine.scene.dynamic.DynamicMesh.Range;
import org.joml.Vector3d;

/**
 * The mesh of the portal gun with the hand and the forearm that hold it, of the character's materials. The gun points
 * along −z, its barrel's axis is at {@link #AXIS_METRES} above the origin, which is at the hand. A small hoop, an opening
 * like those it makes, is held before its muzzle by two prongs.
 */
public final class GunMesh {
    /** Height of the barrel's axis. */
    public static final double AXIS_METRES = 0.058;
    /** Position along z of the hoop's middle, where shots leave the gun. */
    public static final double MUZZLE_METRES = -0.345;
    /** Position along z of the middle of the luminous chamber. */
    public static final double CHAMBER_METRES = -0.185;

    /** The middles of the luminous chamber and of the hoop. */
    public static final Vec3 CHAMBER = new Vec3(0, AXIS_METRES, CHAMBER_METRES);

    public static final Vec3 HOOP = new Vec3(0, 0.062, MUZZLE_METRES);

    /** Half the width of the hoop, and half its height. */
    public static final double HOOP_HALF_WIDTH_METRES = 0.055;

    public static final double HOOP_HALF_HEIGHT_METRES = 0.075;

    /** Distance at which half of a lamp's light on the gun itself is left; the same of a shot's flash. */
    public static final double LAMP_REACH_METRES = 0.03;

    public static final double FLASH_REACH_METRES = 0.11;

    /** Fraction of a lamp's light that arrives at right angles: lamps are no points. */
    public static final double WRAPPED = 0.35;

    /** Number of the first material that shines in the colour of the next portal; those after it do so too. */
    public static final int FIRST_LAMP = 8;

    /** The number of the mark that shines only for the second shot. */
    public static final int SECOND_MARK = FIRST_LAMP + 1;

    private static final int CLOTH = 0;
    private static final int PANEL = 1;
    private static final int ACCENT = 2;
    private static final int RUBBER = 3;
    private static final int STEEL = 4;
    private static final int SHELL = 5;
    private static final int METAL = 6;
    private static final int DARK = 7;
    private static final int LAMP = FIRST_LAMP;

    private static final List<Material> MATERIALS = List.of(
            CharacterMesh.MATERIALS.get(0),
            CharacterMesh.MATERIALS.get(1),
            CharacterMesh.MATERIALS.get(2),
            material("glove", 0.07, 0.073, 0.08, 0.6, 0),
            material("steel", 0.2, 0.21, 0.23, 0.35, 1),
            CharacterMesh.MATERIALS.get(5),
            CharacterMesh.MATERIALS.get(6),
            material("dark", 0.03, 0.032, 0.036, 0.4, 0),
            material("lamp", 0.05, 0.05, 0.05, 0.3, 0),
            material("mark", 0.05, 0.05, 0.05, 0.3, 0));

    /** Fineness of the mesh for small pictures. */
    private static final double COARSE = 0.3;

    /** The space, in the gun's frame, in which the eye is whatever the gun's motion. */
    public static final Aabb EYES = new Aabb(-0.34, -0.01, 0.45, -0.08, 0.3, 0.67);

    private static final double AXIS = AXIS_METRES;

    private final Builder mesh;
    /** The number of sides of a rounded shape, as a share of the full number. */
    private final double fineness;

    private GunMesh(Builder mesh, double fineness) {
        this.mesh = mesh;
        this.fineness = fineness;
    }

    private static Material material(String name, double r, double g, double b, double roughness, double metallic) {
        return new Material(name, new Vec3(r, g, b), null, roughness, metallic, null, Vec3.ZERO, 1);
    }

    /** Returns the materials by the numbers in the vertices. */
    public static List<Surface> materials() {
        return MATERIALS.stream()
                .map(material -> new Surface(material, Slot.NONE, Slot.NONE))
                .toList();
    }

    /** The mesh with the ranges of its two levels of detail; all vertices belong to part 0. */
    public record Model(DynamicMesh mesh, Range fine, Range coarse) {}

    /** Returns the model. */
    public static Model make() {
        Builder mesh = new Builder();
        Range fine = new GunMesh(mesh, 1).add();
        Range coarse = new GunMesh(mesh, COARSE).add();
        return withoutBacks(mesh.finished(), fine, coarse);
    }

    /** Drops the triangles that face away from the eye wherever {@link #EYES} it is: half of them. */
    private static Model withoutBacks(DynamicMesh all, Range fine, Range coarse) {
        IntBuffer kept = ByteBuffer.allocateDirect(4 * all.indices().limit())
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
        Range[] left = new Range[2];
        for (Range range : new Range[] {fine, coarse}) {
            int first = kept.position();
            for (int i = range.first(); i < range.first() + range.count(); i += 3) {
                if (mayFaceEye(all, i)) {
                    kept.put(all.indices().get(i))
                            .put(all.indices().get(i + 1))
                            .put(all.indices().get(i + 2));
                }
            }
            left[range == fine ? 0 : 1] = new Range(first, kept.position() - first);
        }
        return new Model(new DynamicMesh(all.vertices(), kept.flip()), left[0], left[1]);
    }

    private static boolean mayFaceEye(DynamicMesh all, int triangle) {
        Vector3d a = corner(all, triangle);
        Vector3d b = corner(all, triangle + 1).sub(a);
        Vector3d normal = b.cross(corner(all, triangle + 2).sub(a));
        // The corner of the box that is farthest in front of the triangle.
        double x = normal.x > 0 ? EYES.maxX() : EYES.minX();
        double y = normal.y > 0 ? EYES.maxY() : EYES.minY();
        double z = normal.z > 0 ? EYES.maxZ() : EYES.minZ();
        return normal.dot(x - a.x, y - a.y, z - a.z) > 0;
    }

    private static Vector3d corner(DynamicMesh all, int index) {
        int at = all.indices().get(index) * DynamicMesh.VERTEX_BYTES;
        return new Vector3d(
                all.vertices().getFloat(at),
                all.vertices().getFloat(at + 4),
                all.vertices().getFloat(at + 8));
    }

    private Range add() {
        int first = mesh.indexCount();
        barrel();
        shell();
        muzzle();
        rear();
        handle();
        hand();
        arm();
        return mesh.since(first);
    }

    /** Returns true where details are left out that a small picture does not show. */
    private boolean isCoarse() {
        return fineness < 1;
    }

    private int sides(int full) {
        return Math.max(6, 2 * (int) Math.round(full * fineness / 2));
    }

    private void put(int material, Loft loft) {
        mesh.tag(0, material);
        loft.addTo(mesh);
    }

    private void put(int material, int sides, Superellipsoid shape) {
        mesh.tag(0, material);
        shape.addTo(mesh, sides(sides));
    }

    private void hoop(int material, double z, double... halves) {
        mesh.tag(0, material);
        Loft.hoop(mesh, new double[] {0, AXIS + 0.004, z}, halves, Math.max(20, sides(40)));
    }

    private Loft turned(double... zAndRadius) {
        return Loft.edged(Math.max(12, sides(24))).turned(0, AXIS, zAndRadius);
    }

    private void barrel() {
        // The core, then the chamber between two collars.
        put(STEEL, turned(-0.11, 0.033, -0.15, 0.033));
        put(METAL, turned(-0.128, 0.040, -0.131, 0.0445, -0.147, 0.0445, -0.151, 0.040, -0.151, 0.022));
        put(LAMP, turned(-0.149, 0.024, -0.158, 0.0262, -0.212, 0.0262, -0.221, 0.024));
        put(METAL, turned(-0.219, 0.022, -0.219, 0.040, -0.222, 0.0435, -0.232, 0.0435, -0.236, 0.040, -0.236, 0.034));
        if (isCoarse()) {
            return;
        }
        put(ACCENT, turned(-0.2265, 0.0438, -0.2265, 0.0446, -0.2295, 0.0446, -0.2295, 0.0438));
        // Bars of a cage around the chamber.
        for (int bar = 0; bar < 3; bar++) {
            double angle = Math.PI * (0.5 + bar / 1.5);
            double x = 0.0375 * Math.cos(angle);
            double y = AXIS + 0.0375 * Math.sin(angle);
            put(
                    STEEL,
                    Loft.smooth(sides(8))
                            .at(x, y, -0.146, 0.0048)
                            .at(x, y, -0.16, 0.0048)
                            .at(x, y, -0.21, 0.0048)
                            .at(x, y, -0.224, 0.0048));
        }
    }

    private void shell() {
        // The white body: flat flanks with round edges, bevelled at both ends.
        put(
                SHELL,
                Loft.smooth(sides(28))
                        .roundness(0.6)
                        .at(0, 0.061, 0.1035, 0.0235, 0.0225)
                        .at(0, 0.061, 0.1028, 0.0345, 0.0325)
                        .at(0, 0.061, 0.098, 0.041, 0.037)
                        .at(0, 0.063, 0.085, 0.046, 0.042)
                        .at(0, 0.065, 0.03, 0.052, 0.048)
                        .at(0, 0.064, -0.03, 0.053, 0.048)
                        .at(0, 0.062, -0.085, 0.048, 0.044)
                        .at(0, 0.06, -0.11, 0.044, 0.041)
                        .at(0, 0.059, -0.12, 0.040, 0.038)
                        .at(0, 0.059, -0.122, 0.034, 0.032));
        // A dark seam all around, and a spine with the sight on top.
        put(
                DARK,
                Loft.smooth(sides(28))
                        .roundness(0.6)
                        .at(0, 0.0645, -0.0005, 0.0505, 0.0460)
                        .at(0, 0.0645, -0.0010, 0.0531, 0.0487)
                        .at(0, 0.0645, -0.0060, 0.0533, 0.0487)
                        .at(0, 0.0645, -0.0065, 0.0505, 0.0460));
        put(
                PANEL,
                20,
                Superellipsoid.at(0, 0.109, 0.032).size(0.0185, 0.0115, 0.06).edges(0.45, 0.45));
        put(
                ACCENT,
                12,
                Superellipsoid.at(0, 0.1195, 0.008).size(0.004, 0.004, 0.026).edges(0.5, 0.5));
        put(
                DARK,
                12,
                Superellipsoid.at(0, 0.107, -0.06).size(0.012, 0.0085, 0.034).edges(0.4, 0.4));
        // On the left alone: the other flank is never seen.
        put(
                PANEL,
                16,
                Superellipsoid.at(-0.0495, 0.062, -0.05)
                        .size(0.0065, 0.021, 0.035)
                        .edges(0.4, 0.4));
        put(
                DARK,
                16,
                Superellipsoid.at(-0.0485, 0.063, 0.042)
                        .size(0.0055, 0.024, 0.028)
                        .edges(0.45, 0.45));
        if (!isCoarse()) {
            put(
                    STEEL,
                    12,
                    Superellipsoid.at(-0.0525, 0.063, 0.042)
                            .size(0.004, 0.013, 0.013)
                            .edges(0.7, 1));
        }
    }

    /** The hoop and its prongs; the light runs along the inside of the hoop and faces the player. */
    private void muzzle() {
        hoop(DARK, MUZZLE_METRES, 0.058, 0.078, 0.0105, 0.0125);
        hoop(LAMP, MUZZLE_METRES + 0.0105, HOOP_HALF_WIDTH_METRES, HOOP_HALF_HEIGHT_METRES, 0.0048, 0.0052);
        for (int side = -1; side <= 1; side += 2) {
            put(
                    SHELL,
                    Loft.smooth(sides(14))
                            .roundness(0.6)
                            .up(0, 1, 0)
                            .at(0.040 * side, AXIS, -0.118, 0.0, 0.0)
                            .at(0.041 * side, AXIS, -0.12, 0.008, 0.015)
                            .at(0.050 * side, AXIS, -0.16, 0.010, 0.0185)
                            .at(0.066 * side, AXIS, -0.215, 0.0105, 0.0175)
                            .at(0.075 * side, AXIS + 0.002, -0.27, 0.0095, 0.0155)
                            .at(0.072 * side, AXIS + 0.004, -0.32, 0.008, 0.0125)
                            .at(0.066 * side, AXIS + 0.004, -0.352, 0.006, 0.010)
                            .at(0.064 * side, AXIS + 0.004, -0.358, 0.0, 0.0));
        }
        put(
                ACCENT,
                10,
                Superellipsoid.at(-0.0785, AXIS + 0.001, -0.245)
                        .size(0.006, 0.0045, 0.030)
                        .edges(0.5, 0.5));
    }

    /** The face towards the player: a gauge whose ring shines, with a mark for each shot. */
    private void rear() {
        put(STEEL, turned(0.1075, 0.0, 0.1075, 0.0285, 0.105, 0.0315, 0.099, 0.0315));
        put(DARK, turned(0.1095, 0, 0.1095, 0.0235, 0.107, 0.0255));
        put(LAMP, turned(0.111, 0.0145, 0.111, 0.0200, 0.1085, 0.0212));
        put(
                LAMP,
                10,
                Superellipsoid.at(-0.0068, 0.1165, 0.068)
                        .size(0.0046, 0.0062, 0.0115)
                        .edges(0.5, 0.5));
        put(
                SECOND_MARK,
                10,
                Superellipsoid.at(0.0068, 0.1165, 0.068)
                        .size(0.0046, 0.0062, 0.0115)
                        .edges(0.5, 0.5));
    }

    private void handle() {
        put(
                RUBBER,
                Loft.smooth(sides(14))
                        .roundness(0.75)
                        .up(0, 0, -1)
                        .at(0, 0.024, 0.028, 0.021, 0.03)
                        .at(0, -0.03, 0.04, 0.019, 0.027)
                        .at(0, -0.095, 0.06, 0.021, 0.029)
                        .at(0, -0.112, 0.065, 0.021, 0.029)
                        .at(0, -0.114, 0.066, 0, 0));
        if (isCoarse()) {
            return;
        }
        put(
                STEEL,
                Loft.smooth(sides(10))
                        .up(1, 0, 0)
                        .at(0, 0.014, -0.062, 0.004, 0.008)
                        .at(0, -0.012, -0.058, 0.004, 0.008)
                        .at(0, -0.032, -0.036, 0.004, 0.008)
                        .at(0, -0.034, 0.0, 0.004, 0.008)
                        .at(0, -0.03, 0.02, 0.004, 0.008));
    }

    private void hand() {
        // The palm behind and to the right of the handle, and the back of the hand with its plate.
        put(
                RUBBER,
                Loft.smooth(sides(18))
                        .roundness(0.8)
                        .up(0, 0, -1)
                        .at(0.017, 0.014, 0.064, 0, 0)
                        .at(0.017, 0.012, 0.064, 0.018, 0.02)
                        .at(0.02, -0.004, 0.064, 0.026, 0.031)
                        .at(0.021, -0.04, 0.071, 0.028, 0.033)
                        .at(0.02, -0.075, 0.08, 0.024, 0.029)
                        .at(0.018, -0.09, 0.084, 0, 0));
        put(
                PANEL,
                12,
                Superellipsoid.at(0.044, -0.032, 0.07).size(0.009, 0.032, 0.025).edges(0.5, 0.5));
        for (int finger = 0; finger < (isCoarse() ? 3 : 4); finger++) {
            finger(finger);
        }
        // The thumb lies along the left of the handle, forward.
        put(
                RUBBER,
                Loft.smooth(sides(10))
                        .at(0.012, -0.004, 0.086, 0, 0)
                        .at(0.008, -0.002, 0.084, 0.0125)
                        .at(-0.016, 0.001, 0.07, 0.0145)
                        .at(-0.029, 0.004, 0.044, 0.0128)
                        .at(-0.031, 0.006, 0.016, 0.0115)
                        .at(-0.029, 0.006, 0.004, 0.0085)
                        .at(-0.028, 0.006, 0.0, 0));
    }

    private void finger(int finger) {
        double y = -0.011 - 0.0225 * finger;
        double z = 0.006 * finger;
        double r = 0.0118 - (finger == 3 ? 0.001 : 0);
        put(
                RUBBER,
                Loft.smooth(sides(10))
                        .at(0.031, y - 0.002, 0.002 + z, r)
                        .at(0.006, y - 0.003, -0.012 + z, r)
                        .at(-0.018, y - 0.003, -0.004 + z, r * 0.95)
                        .at(-0.028, y - 0.003, 0.01 + z, r * 0.8)
                        .at(-0.03, y - 0.003, 0.016 + z, 0, 0));
    }

    /** The forearm as in {@link CharacterMesh}: cuff, panel, stripe and cloth. */
    private void arm() {
        double[] wrist = {0.021, -0.062, 0.1};
        double[] elbow = {0.15, -0.21, 0.37};
        put(
                RUBBER,
                Loft.smooth(sides(16))
                        .at(0.02, -0.045, 0.076, 0, 0)
                        .at(0.02, -0.047, 0.079, 0.022, 0.026)
                        .at(wrist[0], wrist[1], wrist[2], 0.0275, 0.030)
                        .at(0.035, -0.078, 0.13, 0.031, 0.033)
                        .at(0.052, -0.098, 0.165, 0.036, 0.038));
        put(RUBBER, sleeve(wrist, elbow, 0.20, 0.36, 0.042, 0.0425, 0.002));
        put(ACCENT, sleeve(wrist, elbow, 0.37, 0.42, 0.0425, 0.0425, 0.0015));
        put(
                CLOTH,
                Loft.smooth(sides(18))
                        .at(0.053, -0.099, 0.168, 0.036, 0.038)
                        .at(0.084, -0.135, 0.232, 0.045, 0.047)
                        .at(0.117, -0.173, 0.301, 0.05, 0.052)
                        .at(elbow[0], elbow[1], elbow[2], 0.05, 0.05));
        put(PANEL, sleeve(wrist, elbow, 0.46, 0.86, 0.0475, 0.0535, 0.003));
        if (isCoarse()) {
            return;
        }
        put(METAL, sleeve(wrist, elbow, 0.50, 0.53, 0.0515, 0.052, 0.001));
    }

    /** A bevelled ring around the forearm, from one share of its length to another. */
    private Loft sleeve(
            double[] wrist, double[] elbow, double from, double to, double radius, double last, double bevel) {
        Loft loft = Loft.edged(sides(18));
        double length =
                Math.sqrt(square(elbow[0] - wrist[0]) + square(elbow[1] - wrist[1]) + square(elbow[2] - wrist[2]));
        double[] shares = {from, from, from + bevel / length, to - bevel / length, to, to};
        double[] radii = {0.02, radius - bevel, radius, last, last - bevel, 0.02};
        for (int i = 0; i < shares.length; i++) {
            double s = shares[i];
            loft.at(
                    wrist[0] + s * (elbow[0] - wrist[0]),
                    wrist[1] + s * (elbow[1] - wrist[1]),
                    wrist[2] + s * (elbow[2] - wrist[2]),
                    radii[i]);
        }
        return loft;
    }

    private static double square(double x) {
        return x * x;
    }
}
