package nephele.scenes.fixed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.asset.Picture;
import nephele.engine.math.Vec3;
import nephele.engine.model.Mesh;
import nephele.scenes.fixed.FixedSceneDrawing.Source;
import nephele.scenes.fixed.FixedSceneDrawing.Sources;
import nephele.scenes.xml.Dialect;
import nephele.scenes.xml.XmlGroup;
import nephele.scenes.xml.XmlGroup.Step;
import nephele.scenes.xml.XmlLight;
import nephele.scenes.xml.XmlModel;
import nephele.scenes.xml.XmlModel.Colours;
import nephele.scenes.xml.XmlScene;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Triangles with their own normals, rotated and stretched, equal the light model's twin in every pixel. */
class ShadingGlTest {
    private static final int TRIANGLES = 12;
    private static final XmlScene.Eye EYE =
            new XmlScene.Eye(new Vec3(0.3, 0.4, 3), Vec3.ZERO, new Vec3(0, 1, 0), 60, 1, 100);
    private static final Colours COLOURS = new Colours(
            new Vec3(0.7, 0.5, 0.3), new Vec3(0.1, 0.05, 0.02), new Vec3(0.6, 0.6, 0.8), new Vec3(0, 0.02, 0.1), 20);

    private final SplittableRandom random = new SplittableRandom(5);

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "WIREFRAME")
    void everyPixelIsTheTwins(Shading shading) {
        int compared = 0;
        try (var scenes = new DrawnScenes()) {
            for (int i = 0; i < TRIANGLES; i++) {
                compared += compare(scenes, shading);
            }
        }
        assertTrue(compared > 10_000, compared + " pixels");
    }

    private int compare(DrawnScenes scenes, Shading shading) {
        Mesh mesh = triangle();
        var steps = List.<Step>of(
                new Step.Rotate(new Vec3(0, 1, 0), random.nextInt(50) - 25), new Step.Scale(new Vec3(1.2, 0.8, -0.9)));
        Matrix4d place = new Matrix4d()
                .rotateY(Math.toRadians(((Step.Rotate) steps.get(0)).angleDegrees()))
                .scale(1.2, 0.8, -0.9);
        List<XmlLight> lights = List.of(
                new XmlLight.Point(new Vec3(1, 2, 2)),
                new XmlLight.Directional(new Vec3(-1, 0.5, 1)),
                new XmlLight.Spot(new Vec3(0, 0, 4), new Vec3(0.1, 0, -1), 20, 3));
        var model = new XmlModel(1, "triangle", null, COLOURS);
        var root = new XmlGroup(1, steps, List.of(), List.of(model), List.of());
        var scene = new XmlScene(Dialect.WORLD, new XmlScene.Window(1, 1), EYE, lights, root, List.of());
        int[] pixels = scenes.pixels(
                new Sources(new Source(scene, only(mesh)), null, null), SceneAppearance.USUAL.with(shading));
        var view = FixedSceneDrawing.view(EYE, 1);
        var light = new FixedLight(view.back().toVector(), lights, EnumSet.allOf(LightTerm.class));
        return new Twin(mesh, place, light, shading).compare(view.eye().toVector(), pixels);
    }

    private static SceneFiles only(Mesh mesh) {
        return new SceneFiles() {
            @Override
            public Mesh mesh(XmlModel model) {
                return mesh;
            }

            @Override
            public Picture picture(XmlModel model) {
                return null;
            }
        };
    }

    /** Clockwise seen from +z, because the transform mirrors it. */
    private Mesh triangle() {
        float[] positions = {-1, -1, jitter(), 0.2f, 1.1f, jitter(), 1.1f, -0.8f, jitter()};
        float[] normals = new float[9];
        for (int v = 0; v < 3; v++) {
            Vector3d n = new Vector3d(2 * jitter(), 2 * jitter(), -1).normalize();
            normals[3 * v] = (float) n.x;
            normals[3 * v + 1] = (float) n.y;
            normals[3 * v + 2] = (float) n.z;
        }
        return new Mesh(positions, normals, new float[6], new int[] {0, 1, 2});
    }

    private float jitter() {
        return (float) (random.nextDouble() - 0.5) * 0.8f;
    }

    /** The same triangle by ray casting. */
    private static final class Twin {
        private final Vector3d[] points = new Vector3d[3];
        private final Vector3d[] normals = new Vector3d[3];
        private final FixedLight light;
        private final Shading shading;

        Twin(Mesh mesh, Matrix4d place, FixedLight light, Shading shading) {
            this.light = light;
            this.shading = shading;
            Matrix3d forNormals = place.get3x3(new Matrix3d()).invert().transpose();
            for (int v = 0; v < 3; v++) {
                points[v] = place.transformPosition(vertex(mesh.positions(), v));
                normals[v] = forNormals.transform(vertex(mesh.normals(), v)).normalize();
            }
        }

        private static Vector3d vertex(float[] values, int v) {
            return new Vector3d(values[3 * v], values[3 * v + 1], values[3 * v + 2]);
        }

        int compare(Vector3d eye, int[] pixels) {
            var view = FixedSceneDrawing.view(EYE, 1);
            int compared = 0;
            for (int i = 0; i < pixels.length; i++) {
                double half = view.projection().tanHalfHeight();
                double x = half * (2 * (i % DrawnScenes.SIZE + 0.5) / DrawnScenes.SIZE - 1);
                double y = half * (2 * (i / DrawnScenes.SIZE + 0.5) / DrawnScenes.SIZE - 1);
                Vector3d weights = hit(eye, view.direction(x, y, -1, new Vector3d()));
                if (weights != null) {
                    compared++;
                    Vector3d expected = colour(weights).mul(255);
                    for (int channel = 0; channel < 3; channel++) {
                        assertEquals(
                                expected.get(channel), DrawnScenes.channel(pixels[i], channel), 1.01, "pixel " + i);
                    }
                }
            }
            return compared;
        }

        /** Returns barycentric weights of a ray's hit; {@code null} outside and near the edges. */
        private Vector3d hit(Vector3d eye, Vector3d direction) {
            var m = new Matrix3d(
                    points[0].sub(eye, new Vector3d()),
                    points[1].sub(eye, new Vector3d()),
                    points[2].sub(eye, new Vector3d()));
            Vector3d shares = m.invert().transform(direction, new Vector3d());
            shares.div(shares.x + shares.y + shares.z);
            return Math.min(shares.x, Math.min(shares.y, shares.z)) > 0.02 ? shares : null;
        }

        private Vector3d colour(Vector3d weights) {
            return switch (shading) {
                case FLAT -> light.lit(COLOURS, points[2], normals[2]);
                case GOURAUD ->
                    mixed(
                            weights,
                            light.lit(COLOURS, points[0], normals[0]),
                            light.lit(COLOURS, points[1], normals[1]),
                            light.lit(COLOURS, points[2], normals[2]));
                default ->
                    light.lit(
                            COLOURS,
                            mixed(weights, points[0], points[1], points[2]),
                            mixed(weights, normals[0], normals[1], normals[2]).normalize());
            };
        }

        private static Vector3d mixed(Vector3d weights, Vector3d a, Vector3d b, Vector3d c) {
            return new Vector3d().fma(weights.x, a).fma(weights.y, b).fma(weights.z, c);
        }
    }
}
