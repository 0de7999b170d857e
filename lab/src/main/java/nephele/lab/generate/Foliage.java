package nephele.lab.generate;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Opaque leaves: dark lobes under shells of single leaves, which overlap and face outward. Normals are bent away from
 * the crown's middle, so that a crown is lit softly as one volume; shades go from dark inside and below to light
 * outside and above.
 *
 * @param crown the envelope of all lobes
 * @param coreDivisions of the icosahedron below the leaves
 * @param leaves single leaves on a lobe
 * @param leafMetres length of a leaf
 */
record Foliage(PlantPaint paint, Clump crown, int coreDivisions, int leaves, double leafMetres) {
    private static final double HIDDEN_DEPTH = 0.8;
    private static final double CORE_DEPTH = 0.85;

    private static final double OWN_NORMAL = 0.5;
    private static final double CROWN_NORMAL = 0.6;
    private static final double BELOW_CROWN = 0.2;
    private static final Vector3dc TOWARDS_SKY = new Vector3d(0, 0.2, 0);
    private static final double LEAF_WIDTH = 0.3;
    private static final double GOLDEN_ANGLE = StrictMath.PI * (3 - StrictMath.sqrt(5));

    /** Adds the lobes; what is deep inside another lobe is left out. */
    void build(List<Clump> lobes, PlantMesh mesh, PlantDice dice) {
        Icosphere sphere = Icosphere.of(coreDivisions);
        for (Clump lobe : lobes) {
            List<Clump> others = lobes.stream().filter(other -> other != lobe).toList();
            double tone = dice.around(0.12);
            core(lobe, others, tone, sphere, mesh, dice);
            for (int i = 0; i < leaves; i++) {
                double y = 1 - 2 * (i + 0.5) / leaves;
                double flat = StrictMath.sqrt(1 - y * y);
                double turn = GOLDEN_ANGLE * i;
                Vector3d direction = new Vector3d(flat * StrictMath.cos(turn), y, flat * StrictMath.sin(turn));
                leaf(lobe, direction.fma(0.3, dice.inBall()).normalize(), others, tone, mesh, dice);
            }
        }
    }

    private void core(Clump lobe, List<Clump> others, double tone, Icosphere sphere, PlantMesh mesh, PlantDice dice) {
        int count = sphere.directions().size();
        int[] vertices = new int[count];
        boolean[] hidden = new boolean[count];
        for (int i = 0; i < count; i++) {
            Vector3d direction = sphere.directions().get(i);
            Vector3d point = lobe.at(direction, CORE_DEPTH + dice.around(0.1));
            hidden[i] = others.stream().anyMatch(other -> other.depth(point) < HIDDEN_DEPTH);
            Vector3d normal = normal(point, lobe.normal(direction));
            vertices[i] = mesh.vertex(point, normal, paint, shade(point, direction.y, tone) - 0.1);
        }
        for (int[] t : sphere.triangles()) {
            if (!hidden[t[0]] || !hidden[t[1]] || !hidden[t[2]]) {
                mesh.triangle(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
            }
        }
    }

    /** Adds a folded leaf that grows out of a lobe and is seen from outside. */
    private void leaf(Clump lobe, Vector3d direction, List<Clump> others, double tone, PlantMesh mesh, PlantDice dice) {
        Vector3d base = lobe.at(direction, footDepth());
        Vector3d out = lobe.normal(direction);
        Vector3d along = dice.direction().sub(0, 0.35, 0);
        along.fma(-along.dot(out), out);
        if (along.length() < 0.1 || others.stream().anyMatch(other -> other.depth(base) < HIDDEN_DEPTH)) {
            return;
        }
        along.normalize().fma(dice.between(0.45, 0.9), out).normalize();
        double length = leafMetres * dice.between(0.8, 1.2);
        Vector3d beside = new Vector3d(along).cross(out).normalize(LEAF_WIDTH * length);
        Vector3d normal = normal(base, out);
        double shade = shade(base, direction.y, tone) + dice.around(0.1);
        Vector3d middle = new Vector3d(base).fma(0.48 * length, along).fma(0.06 * length, out);
        Vector3d end = new Vector3d(base).fma(length, along).fma(-0.1 * length, out);
        int foot = mesh.vertex(base, normal, paint, shade - 0.1);
        int left = mesh.vertex(new Vector3d(middle).add(beside), normal, paint, shade + 0.03);
        int right = mesh.vertex(new Vector3d(middle).sub(beside), normal, paint, shade + 0.03);
        int tip = mesh.vertex(end, normal, paint, shade + 0.12);
        mesh.triangle(foot, left, tip);
        mesh.triangle(foot, tip, right);
    }

    /** Returns the depth of a leaf's foot, just below the core's flat faces. */
    private double footDepth() {
        return coreDivisions == 0 ? 0.64 : 0.76;
    }

    /** Returns the bent normal; below a crown it turns to the horizon, from where most of the light there comes. */
    private Vector3d normal(Vector3dc point, Vector3dc own) {
        Vector3d outward = new Vector3d(point).sub(crown.centre());
        outward.div(crown.halfWidth(), crown.halfHeight(), crown.halfWidth());
        Vector3d bent = new Vector3d(own).mul(OWN_NORMAL);
        bent.fma(CROWN_NORMAL / Math.max(1e-3, outward.length()), outward).add(TOWARDS_SKY);
        return bent.y < 0 ? bent.mul(1, BELOW_CROWN, 1) : bent;
    }

    private double shade(Vector3d point, double upness, double tone) {
        double height = (point.y - crown.centre().y()) / crown.halfHeight();
        double outside = Math.min(1, crown.depth(point));
        return 0.22 + 0.18 * height + 0.14 * upness + 0.26 * outside + tone;
    }
}
