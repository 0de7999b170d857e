package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement.TransformStep.Rotate;
import nephele.engine.level.ModelPlacement.TransformStep.Scale;
import nephele.engine.level.ModelPlacement.TransformStep.Translate;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.View;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Models look like solids of the same shape, and as derived values. */
class ModelGlTest {
    private static final int SIZE = 160;
    /** For meshes with triangles of 2 to 3 degrees: a tenth of such an angle in the normal. */
    private static final double COSINE = 0.006;

    private static final Vec3 CENTRE = new Vec3(0.2, 0.6, -0.3);
    private static final Vec3 SIZE_OF_BOX = new Vec3(1.4, 1, 0.8);

    private static TestLevel room() {
        return new TestLevel()
                .castingSun(new Vec3(0.5, 0.8, 0.3), 2)
                .light(new Light.Point("l", new Vec3(-2, 2.5, 1.5), TestLevel.grey(6), 12, true))
                .material("floor", TestLevel.grey(0.6))
                .material(new Material("gloss", new Vec3(0.7, 0.3, 0.2), null, 0.4, 0.0, null, Vec3.ZERO, 1))
                .material("matt", new Vec3(0.2, 0.5, 0.3))
                .box("floor", new Vec3(0, -0.5, 0), new Vec3(12, 1, 12))
                .box("floor", new Vec3(-3, 1, -3), new Vec3(1, 2, 2));
    }

    private static Translate at(Vec3 place) {
        return new Translate(place);
    }

    /**
     * A solid and meshes of the same box, mirrored and fine ones too, have the same pixels except for rounding at
     * edges.
     */
    @Test
    void aBoxModelLooksLikeABox() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(new Vec3(1.6, 1.8, 2), new Vec3(0, 0.4, -0.5));
            for (String material : new String[] {"gloss", "matt"}) {
                float[] solid = picture(offscreen, room().ambient(0.2).box(material, CENTRE, SIZE_OF_BOX), view);
                Scale[] scales = {
                    new Scale(SIZE_OF_BOX),
                    new Scale(new Vec3(-SIZE_OF_BOX.x(), SIZE_OF_BOX.y(), SIZE_OF_BOX.z())),
                    new Scale(SIZE_OF_BOX.negated())
                };
                for (Scale scale : scales) {
                    for (String file : new String[] {"box_1_1.3d", "box_1_4.3d"}) {
                        TestLevel level = room().ambient(0.2).model(file, material, at(CENTRE), scale);
                        assertAlike(solid, picture(offscreen, level, view), 0.002, file + " " + scale + material);
                    }
                }
            }
        }
    }

    /** Under a sky the light differs slightly: a solid's is baked in texels, a model's at its vertices. */
    @Test
    void theSkyLightsABoxModelLikeABox() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(new Vec3(1.6, 1.8, 2), new Vec3(0, 0.4, -0.5));
            Sky sky = new Sky.Gradient(new Vec3(0.4, 0.6, 1), TestLevel.grey(0.8), TestLevel.grey(0.2));
            TestLevel solid = room().skyLight().sky(sky).box("matt", CENTRE, SIZE_OF_BOX);
            float[] first = picture(offscreen, solid, view);
            for (String file : new String[] {"box_1_1.3d", "box_1_4.3d"}) {
                TestLevel model = room().skyLight().sky(sky).model(file, "matt", at(CENTRE), new Scale(SIZE_OF_BOX));
                assertAlikeTogether(first, picture(offscreen, model, view), 0.01);
            }
        }
    }

    /** A floor of two triangles is darker at the foot of walls, by the vertices added for it. */
    @Test
    void theSkyLightsAFloorOfTwoTriangles() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(new Vec3(1.6, 2.5, 2), new Vec3(-0.5, 0, -0.5));
            float[] solid =
                    picture(offscreen, wallUnderSky().box("matt", new Vec3(0, -0.5, 0), new Vec3(8, 1, 8)), view);
            assertAlikeTogether(solid, picture(offscreen, wallUnderSky().model("plane_8_1.3d", "matt"), view), 0.02);
        }
    }

    private static TestLevel wallUnderSky() {
        return new TestLevel()
                .skyLight()
                .sky(new Sky.Constant(TestLevel.grey(1)))
                .material("matt", TestLevel.grey(0.5))
                .box(null, new Vec3(0, 2, -2), new Vec3(8, 4, 0.5));
    }

    private static void assertAlikeTogether(float[] expected, float[] found, double share) {
        double off = 0;
        double sum = 0;
        for (int i = 0; i < expected.length; i++) {
            off += Math.abs(expected[i] - found[i]);
            sum += expected[i];
        }
        assertTrue(off < share * sum, "off by " + off / sum);
    }

    private static float[] picture(Offscreen offscreen, TestLevel level, View view) {
        return offscreen.radiance(level.level(), TestAssets.NONE, view);
    }

    private static void assertAlike(float[] expected, float[] found, double shareThatMayDiffer, String what) {
        int differing = 0;
        for (int i = 0; i < expected.length; i++) {
            differing += Math.abs(expected[i] - found[i]) > 2e-3 * Math.max(0.2, expected[i]) ? 1 : 0;
        }
        assertTrue(differing <= shareThatMayDiffer * expected.length, what + ": " + differing + " values differ");
    }

    /** A fine sphere under a sun reflects albedo / π · irradiance · cosine, with the smooth normal of each point. */
    @Test
    void aBallIsLitAsASmoothOne() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            Vector3d toSun = new Vector3d(0.6, 0.5, 0.7).normalize();
            Level level = new TestLevel()
                    .castingSun(Vec3.of(toSun), 3)
                    .ambient(0)
                    .material("m", TestLevel.grey(0.5))
                    .model("sphere_1_192_128.3d", "m", new Rotate(new Vec3(1, 2, 3), 40), new Scale(new Vec3(-2, 2, 2)))
                    .level();
            double distance = 5;
            float[] rgb =
                    offscreen.radiance(level, TestAssets.NONE, offscreen.view(new Vec3(0, 0, distance), Vec3.ZERO));
            int lit = 0;
            for (int i = 0; i < SIZE * SIZE; i++) {
                Vector3d way = new Vector3d(2 * (i % SIZE + 0.5) / SIZE - 1, 2 * (i / SIZE + 0.5) / SIZE - 1, -1);
                Vector3d normal = onBall(way.normalize(), distance, 2);
                double cosine = normal == null ? 0 : normal.dot(toSun);
                if (normal != null && normal.dot(way) < -0.3 && (cosine < -0.15 || cosine > 0.3)) {
                    assertEquals(Math.max(0, cosine), rgb[3 * i] * Math.PI / 1.5, COSINE, "pixel " + i);
                    lit += cosine > 0 ? 1 : 0;
                }
            }
            assertTrue(lit > 500, lit + " pixels");
        }
    }

    /** Returns {@code null} for a miss. */
    private static Vector3d onBall(Vector3d way, double distance, double radius) {
        double middle = distance * -way.z;
        double inside = radius * radius - distance * distance + middle * middle;
        double along = middle - Math.sqrt(Math.max(inside, 0));
        return inside < 0
                ? null
                : new Vector3d(way).mul(along).add(0, 0, distance).div(radius);
    }

    /** Under non-uniform and mirrored scales the shading normal stays that of the ellipsoid. */
    @Test
    void anEllipsoidIsLitByItsOwnNormals() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            Vector3d toSun = new Vector3d(-0.3, 0.8, 0.6).normalize();
            Vec3 half = new Vec3(2.4, 0.9, 1.3);
            Level level = new TestLevel()
                    .sun(Vec3.of(toSun), 3)
                    .ambient(0)
                    .material("m", TestLevel.grey(0.5))
                    .model("sphere_1_128_96.3d", "m", new Scale(new Vec3(-half.x(), half.y(), -half.z())))
                    .level();
            double distance = 4;
            float[] rgb =
                    offscreen.radiance(level, TestAssets.NONE, offscreen.view(new Vec3(0, 0, distance), Vec3.ZERO));
            int lit = 0;
            for (int i = 0; i < SIZE * SIZE; i++) {
                Vector3d way = new Vector3d(2 * (i % SIZE + 0.5) / SIZE - 1, 2 * (i / SIZE + 0.5) / SIZE - 1, -1);
                Vector3d unit = new Vector3d(way.x / half.x(), way.y / half.y(), way.z / half.z());
                double scale = unit.length();
                Vector3d onUnit = onUnitBall(new Vector3d(0, 0, distance / half.z()), unit.div(scale));
                if (onUnit == null) {
                    continue;
                }
                Vector3d normal =
                        new Vector3d(onUnit.x / half.x(), onUnit.y / half.y(), onUnit.z / half.z()).normalize();
                double cosine = normal.dot(toSun);
                if (normal.dot(way.normalize()) < -0.3 && cosine > 0.3) {
                    assertEquals(cosine, rgb[3 * i] * Math.PI / 1.5, COSINE, "pixel " + i);
                    lit++;
                }
            }
            assertTrue(lit > 500, lit + " pixels");
        }
    }

    private static Vector3d onUnitBall(Vector3d from, Vector3d way) {
        double middle = -from.dot(way);
        double inside = 1 - from.lengthSquared() + middle * middle;
        return inside < 0
                ? null
                : new Vector3d(way).mul(middle - Math.sqrt(inside)).add(from);
    }

    /**
     * The mesh's texture coordinates place a model's picture: on a plane from corner to corner, upright, for any size.
     */
    @Test
    void aPictureLiesAsTheMeshSays() {
        TestAssets assets = new TestAssets().picture("quarters.png", 16, 16, (x, y) -> {
            int[] colours = {0xff0000, 0x00ff00, 0x0000ff, 0xffffff};
            return colours[2 * (y / 8) + x / 8];
        });
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            Level level = new TestLevel()
                    .ambient(1)
                    .textured("m", "quarters.png")
                    .model("plane_2_3.3d", "m", new Rotate(new Vec3(1, 0, 0), 90))
                    .level();
            View view = offscreen.view(new Vec3(0, 0, 1.2), Vec3.ZERO);
            int[] pixels = offscreen.pixels(level, assets, view, RenderSettings.of(Output.PLAIN));
            assertEquals(0xff0000, pixels[SIZE * (SIZE - 30) + 30], "top left");
            assertEquals(0x00ff00, pixels[SIZE * (SIZE - 30) + SIZE - 30], "top right");
            assertEquals(0x0000ff, pixels[SIZE * 30 + 30], "bottom left");
            assertEquals(0xffffff, pixels[SIZE * 30 + SIZE - 30], "bottom right");
        }
    }
}
