package nephele.engine.render.pass.shadow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.engine.scene.light.ShadowFrame;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Drawn shadows equal rays cast on the CPU: the lit and shaded pixels, and the position of edges. */
class ShadowEdgeGlTest {
    private static final int SIZE = 96;
    private static final double AMBIENT = 0.05;
    private static final double INF = Double.POSITIVE_INFINITY;
    private static final Vec3 SUN = new Vec3(0.5, 1, 0.25);

    private static final RenderSettings HDR = RenderSettings.of(Output.HDR);

    private final List<Aabb> boxes = new ArrayList<>();

    private void box(double x, double y, double z, double... size) {
        boxes.add(Aabb.around(new Vec3(x, y, z), new Vec3(size[0], size[1], size[2])));
    }

    private TestLevel level() {
        TestLevel level = new TestLevel().ambient(AMBIENT).material("white", TestLevel.grey(1));
        for (Aabb b : boxes) {
            level.box("white", b.centre(), new Vec3(b.maxX() - b.minX(), b.maxY() - b.minY(), b.maxZ() - b.minZ()));
        }
        return level;
    }

    private static Ray pixelRay(View view, int x, int y) {
        double u = ((2 * x + 1.0) / SIZE - 1) * view.projection().tanHalfWidth();
        double v = ((2 * y + 1.0) / SIZE - 1) * view.projection().tanHalfHeight();
        Vector3d d = view.right().toVector().mul(u).add(view.up().toVector().mul(v));
        d.sub(view.back().toVector());
        return new Ray(view.eye().x(), view.eye().y(), view.eye().z(), d.x, d.y, d.z);
    }

    private record Seen(Vec3 point, Vec3 normal) {}

    private Seen seen(Ray ray) {
        double nearest = INF;
        Aabb box = null;
        for (Aabb b : boxes) {
            double entry = ray.boxEntry(b, INF);
            if (entry < nearest && entry > 0) {
                nearest = entry;
                box = b;
            }
        }
        return box == null || isOnEdge(box, ray.at(nearest))
                ? null
                : new Seen(ray.at(nearest), normal(box, ray.at(nearest)));
    }

    /** Returns true near an edge, where either face may have been drawn. */
    private boolean isOnEdge(Aabb b, Vec3 p) {
        double near = 0.02;
        Aabb around = Aabb.of(List.of(p)).grown(near);
        if (boxes.stream().filter(around::overlaps).count() > 1) {
            return true;
        }
        int faces = p.x() < b.minX() + near || p.x() > b.maxX() - near ? 1 : 0;
        faces += p.y() < b.minY() + near || p.y() > b.maxY() - near ? 1 : 0;
        faces += p.z() < b.minZ() + near || p.z() > b.maxZ() - near ? 1 : 0;
        return faces > 1;
    }

    private static Vec3 normal(Aabb b, Vec3 p) {
        double[] off = {
            b.maxX() - p.x(), p.x() - b.minX(), b.maxY() - p.y(), p.y() - b.minY(), b.maxZ() - p.z(), p.z() - b.minZ()
        };
        int face = 0;
        for (int i = 1; i < 6; i++) {
            face = Math.abs(off[i]) < Math.abs(off[face]) ? i : face;
        }
        double sign = face % 2 == 0 ? 1 : -1;
        return new Vec3(face / 2 == 0 ? sign : 0, face / 2 == 1 ? sign : 0, face / 2 == 2 ? sign : 0);
    }

    /** Returns 0 for shaded, 1 for lit, NaN if a margin around the casters decides. */
    private double lit(Seen seen, Vec3 toLight, double limit, double margin) {
        Vec3 start = new Vec3(
                seen.point.x() + 1e-6 * seen.normal.x(),
                seen.point.y() + 1e-6 * seen.normal.y(),
                seen.point.z() + 1e-6 * seen.normal.z());
        Ray ray = Ray.of(start, toLight);
        boolean surely = false;
        boolean perhaps = false;
        for (Aabb b : boxes) {
            boolean own = b.grown(1e-5).overlaps(Aabb.of(List.of(seen.point)));
            if (!own) {
                surely |= ray.boxEntry(b.grown(-margin), limit) < INF;
                perhaps |= ray.boxEntry(b.grown(margin), limit) < INF;
            }
        }
        return surely ? 0 : perhaps ? Double.NaN : 1;
    }

    /** Every pixel farther than 1½ texels from a shadow's edge is fully lit or fully shaded, as the ray says. */
    @Test
    void theSunsShadowIsWhereRaysSay() {
        box(0, -0.5, 0, 8, 1, 8);
        box(0, 1, 0, 1, 0.25, 1);
        box(-1.5, 0.6, 1, 0.3, 1.2, 0.3);
        box(1.6, 0.25, -0.8, 0.6, 0.5, 1.4);
        Level level = level().castingSun(SUN, Math.PI).level();
        Vec3 sun = Directions.unit(SUN.x(), SUN.y(), SUN.z());
        int[] counts = new int[2];
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            for (Vec3 eye : List.of(new Vec3(2.2, 3, 2.5), new Vec3(-3, 2, 3), new Vec3(0.3, 5, -3))) {
                View view = offscreen.view(eye, new Vec3(-0.3, 0, 0));
                float[] rgb = offscreen.radiance(level, TestAssets.NONE, view);
                for (int i = 0; i < SIZE * SIZE; i++) {
                    Seen seen = seen(pixelRay(view, i % SIZE, i / SIZE));
                    double cosine = seen == null ? 0 : seen.normal.dot(sun);
                    double lit = cosine <= 0 ? 0 : lit(seen, SUN, INF, 1.5 * ShadowFrame.FINEST_TEXEL_METRES);
                    if (seen != null && !Double.isNaN(lit)) {
                        String where = "seen from " + eye + " at " + seen.point;
                        assertEquals(AMBIENT + lit * cosine, rgb[3 * i], 2e-3, where);
                        counts[(int) lit]++;
                    }
                }
            }
        }
        assertTrue(counts[0] > 300 && counts[1] > 10_000, counts[0] + " shaded, " + counts[1] + " lit");
    }

    /** On average over eight positions on the texel grid, the error of the edge is below a quarter of a texel. */
    @Test
    void theSunsShadowIsNotDisplaced() {
        double offAlongX = 0;
        double offAlongZ = 0;
        int places = 8;
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            for (int i = 0; i < places; i++) {
                boxes.clear();
                box(0, -0.5, 0, 8, 1, 8);
                box(0.0062 * i, 1, 0.0094 * i, 1, 0.2, 1);
                Level level = level().castingSun(SUN, Math.PI).level();
                // The edge is the shadow of the box's lower edge on the sun's side, 0.9 m up.
                double edgeX = 0.0062 * i + 0.5 - 0.9 * SUN.x();
                double edgeZ = 0.0094 * i + 0.5 - 0.9 * SUN.z();
                try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, HDR)) {
                    offAlongX += displacement(renderer, offscreen, new Vec3(edgeX, 0, -0.3));
                    offAlongZ += displacement(renderer, offscreen, new Vec3(-0.5, 0, edgeZ));
                }
            }
        }
        double quarterTexel = 0.25 * ShadowFrame.FINEST_TEXEL_METRES;
        assertEquals(0, offAlongX / places, quarterTexel, "metres along x");
        assertEquals(0, offAlongZ / places, quarterTexel, "metres along z");
    }

    /**
     * Returns the excess over one half of the lit part of a picture 7 cm wide, centred on the edge and seen from close
     * above.
     */
    private static double displacement(Renderer renderer, Offscreen offscreen, Vec3 edge) {
        double height = 0.4;
        Projection projection = new Projection(Math.toRadians(10), 1, 0.05, 100);
        Vec3 eye = new Vec3(edge.x(), height, edge.z());
        View view = View.lookAt(eye, edge, new Vec3(0, 0, -1), projection);
        renderer.draw(view, offscreen.picture);
        float[] rgb = renderer.readRadiance();
        double cosine = SUN.y() / SUN.toVector().length();
        double sum = 0;
        for (int i = 0; i < rgb.length; i += 3) {
            sum += (rgb[i] - AMBIENT) / cosine;
        }
        double width = 2 * height * projection.tanHalfHeight();
        return (sum / (rgb.length / 3) - 0.5) * width;
    }

    /** A point light casts shadows to all six sides. */
    @Test
    void aLightsShadowsAreWhereRaysSayOnAllSixSides() {
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                double[] at = new double[3];
                double[] size = {6.2, 6.2, 6.2};
                at[axis] = 3.05 * side;
                size[axis] = 0.1;
                box(at[0], at[1], at[2], size);
                double[] blocker = {0.15 * side, -0.2, 0.1};
                blocker[axis] = (1.1 + 0.2 * axis) * side;
                double width = 0.2 + 0.1 * axis + 0.05 * side;
                box(blocker[0], blocker[1], blocker[2], width, width, width);
            }
        }
        Vec3 light = new Vec3(0.2, 0.1, -0.15);
        Level level = level().light(new Light.Point("lamp", light, TestLevel.grey(20), 20, true))
                .level();
        int[] counts = new int[2];
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            for (int look = 0; look < 6; look++) {
                double side = look % 2 == 0 ? 1 : -1;
                Vec3 ahead = new Vec3(look / 2 == 0 ? side : 0, look / 2 == 1 ? side : 0, look / 2 == 2 ? side : 0);
                Vec3 eye = new Vec3(-0.5 - 1.5 * ahead.x(), 0.6 - 1.5 * ahead.y(), 0.5 - 1.5 * ahead.z());
                Vec3 target = eye.plus(ahead);
                View view = offscreen.view(eye, target);
                float[] rgb = offscreen.radiance(level, TestAssets.NONE, view);
                for (int i = 0; i < SIZE * SIZE; i++) {
                    Seen seen = seen(pixelRay(view, i % SIZE, i / SIZE));
                    if (seen != null) {
                        judgeLight(seen, light, rgb[3 * i], counts);
                    }
                }
            }
        }
        assertTrue(counts[0] > 300 && counts[1] > 20_000, counts[0] + " shaded, " + counts[1] + " lit");
    }

    private void judgeLight(Seen seen, Vec3 light, float radiance, int[] counts) {
        Vec3 toLight = new Vec3(light.x() - seen.point.x(), light.y() - seen.point.y(), light.z() - seen.point.z());
        double cosine = seen.normal.dot(toLight) / toLight.length();
        double lit = lit(seen, toLight, 1, 0.03);
        if (cosine > 0.05 && !Double.isNaN(lit)) {
            double square = toLight.dot(toLight);
            double window = 1 - square * square / 160_000;
            double unshaded = 20 / Math.PI * cosine / square * window * window;
            assertEquals(AMBIENT + lit * unshaded, radiance, 0.01 * unshaded, () -> seen + "");
            counts[(int) lit]++;
        }
    }
}
