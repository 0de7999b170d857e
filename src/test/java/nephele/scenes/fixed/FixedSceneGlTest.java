package nephele.scenes.fixed;

import static nephele.scenes.fixed.DrawnScenes.SIZE;
import static nephele.scenes.fixed.DrawnScenes.centre;
import static nephele.scenes.fixed.DrawnScenes.channel;
import static nephele.scenes.fixed.DrawnScenes.drawn;
import static nephele.scenes.fixed.DrawnScenes.world;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.BareFrame;
import nephele.scenes.fixed.FixedSceneDrawing.Sources;
import nephele.scenes.xml.XmlScene;
import org.joml.Matrix4d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The right parts of an XML scene are drawn. */
class FixedSceneGlTest {
    private static final String LIGHT = "<lights><light type='directional' dirx='1' diry='1' dirz='2'/></lights>";
    private static final String WHITE_AMBIENT = "<color><ambient R='255' G='255' B='255'/></color>";

    private final DrawnScenes scenes = new DrawnScenes();

    @AfterEach
    void close() {
        scenes.close();
    }

    private static String group(String steps, String model) {
        return "<group><transform>" + steps + "</transform><models>" + model + "</models></group>";
    }

    private static String model(String file, String inside) {
        return "<model file='" + file + "'>" + inside + "</model>";
    }

    /** Returns a plane whose face points towards +y. */
    private static String plane(String steps) {
        return world(LIGHT + group(steps, model("plane_2_2.3d", "")));
    }

    @ParameterizedTest
    @EnumSource
    void onlyFrontFacesAreDrawn(Shading shading) {
        var look = SceneAppearance.USUAL.with(shading);
        assertTrue(drawn(scenes.pixels(plane("<rotate angle='90' x='1' y='0' z='0'/>"), look)) > 300);
        assertEquals(0, drawn(scenes.pixels(plane("<rotate angle='-90' x='1' y='0' z='0'/>"), look)));
    }

    /** A mirroring transform keeps the outer side of a face visible. */
    @ParameterizedTest
    @EnumSource
    void mirroredModelsShowTheirOutside(Shading shading) {
        var look = SceneAppearance.USUAL.with(shading);
        String towardsEye = "<rotate angle='90' x='1' y='0' z='0'/>";
        int[] kept = scenes.pixels(plane(towardsEye), look);
        int[] mirrored = scenes.pixels(plane("<scale x='-1' y='1' z='1'/>" + towardsEye), look);
        assertTrue(drawn(mirrored) > 300);
        if (shading != Shading.WIREFRAME) {
            assertArrayEquals(kept, mirrored);
        }
        assertEquals(0, drawn(scenes.pixels(plane("<scale x='1' y='1' z='-1'/>" + towardsEye), look)));
    }

    @Test
    void edgesBehindAFaceAreSeen() {
        var look = SceneAppearance.USUAL.with(Shading.WIREFRAME);
        String near = group("<translate x='0' y='0' z='1'/><scale x='0.5' y='0.5' z='0.5'/>", model("box_1_1.3d", ""));
        String far = group("<translate x='0' y='0' z='-4'/>", model("sphere_3_9_9.3d", ""));
        int[] both = scenes.pixels(world(near + far), look);
        int[] union = scenes.pixels(world(near), look);
        assertTrue(drawn(union) < 400, "edges only");
        int[] behind = scenes.pixels(world(far), look);
        for (int i = 0; i < union.length; i++) {
            union[i] |= behind[i];
        }
        assertArrayEquals(union, both);
        assertTrue(Set.of(0, 0xffffff)
                .containsAll(java.util.Arrays.stream(both).boxed().toList()));
    }

    /** The axes cross the picture, also after a flight far from the scene's own camera. */
    @Test
    void axesCrossThePictureFromAnywhere() {
        var sources = new Sources(scenes.source(world(group("", model("box_1_1.3d", "")))), null, null);
        var look = SceneAppearance.USUAL.withAxes(true);
        var far = new XmlScene.Eye(new Vec3(0, 3, 900), new Vec3(0, 3, 0), new Vec3(0, 1, 0), 60, 1, 1000);
        try (var drawing = FixedSceneDrawing.load(scenes.gl, sources)) {
            drawing.draw(FixedSceneDrawing.view(far, 1), 0, new Matrix4d(), look, scenes.picture);
            int[] pixels = scenes.pixels();
            long red = IntStream.range(0, SIZE * SIZE)
                    .filter(i -> pixels[i] == 0xff0000)
                    .map(i -> i % SIZE)
                    .distinct()
                    .count();
            assertTrue(red > SIZE - 4, red + " columns of the x axis");
        }
    }

    /** On an axis, where that axis is not seen, a cross in the corner shows the directions; elsewhere there is none. */
    @Test
    void aCrossShowsTheDirectionsWhereTheEyeIsOnAnAxis() {
        var sources = new Sources(
                scenes.source(world(group("<translate x='0' y='0' z='-50'/>", model("box_1_1.3d", "")))), null, null);
        var look = SceneAppearance.USUAL.withAxes(true);
        try (var drawing = FixedSceneDrawing.load(scenes.gl, sources)) {
            assertEquals(0, crossPixels(drawing, new Vec3(9, 9, 9), look));
            assertTrue(crossPixels(drawing, Vec3.ZERO, look) > 20);
            assertTrue(crossPixels(drawing, new Vec3(0, 5, 0), look) > 20);
            assertEquals(0, crossPixels(drawing, Vec3.ZERO, SceneAppearance.USUAL));
        }
    }

    /** Returns the pixels in the colour of the cross's x axis, which nothing else has. */
    private long crossPixels(FixedSceneDrawing drawing, Vec3 eye, SceneAppearance look) {
        var from = new XmlScene.Eye(eye, new Vec3(eye.x(), eye.y(), eye.z() - 1), new Vec3(0, 1, 0), 60, 1, 1000);
        drawing.draw(FixedSceneDrawing.view(from, 1), 0, new Matrix4d(), look, scenes.picture);
        return java.util.Arrays.stream(scenes.pixels())
                .filter(pixel -> pixel == 0xff4033)
                .count();
    }

    /** The sum of the terms equals all together; each term is rounded separately. */
    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "WIREFRAME")
    void termsAddUp(Shading shading) {
        String colours = "<color><ambient R='20' G='30' B='5'/><diffuse R='90' G='60' B='20'/>"
                + "<specular R='70' G='70' B='90'/><emissive R='3' G='20' B='40'/><shininess value='12'/></color>";
        String scene = world(LIGHT + group("", model("sphere_1_16_16.3d", colours)));
        int[] whole = scenes.pixels(scene, SceneAppearance.USUAL.with(shading));
        int[][] parts = new int[LightTerm.values().length][];
        for (LightTerm term : LightTerm.values()) {
            parts[term.ordinal()] =
                    scenes.pixels(scene, SceneAppearance.USUAL.with(shading).with(EnumSet.of(term)));
            assertTrue(drawn(parts[term.ordinal()]) > 500, term + " shows something");
        }
        for (int i = 0; i < whole.length; i++) {
            for (int channel = 0; channel < 3; channel++) {
                int sum = 0;
                for (int[] part : parts) {
                    sum += channel(part[i], channel);
                }
                assertEquals(sum, channel(whole[i], channel), 2, "pixel " + i);
            }
        }
    }

    /** Lights of a {@code <scene>} light their group and its subgroups. */
    @Test
    void lightsReachTheirGroupAndThoseBelow() {
        String model = "<models><model file='box_0.5_1.3d' diffR='1' diffG='1' diffB='1'/></models>";
        String inner = "<group><translate x='0.6' y='0' z='0'/>" + model + "</group>";
        String lit = "<group><translate x='-1' y='0' z='4'/>"
                + "<lights><light type='directional' posx='0' posy='0' posz='-1'/></lights>" + model + inner
                + "</group>";
        String unlit = "<group><translate x='1' y='0' z='4'/>" + model + "</group>";
        var look = SceneAppearance.USUAL.with(EnumSet.of(LightTerm.DIFFUSE));
        int[] pixels = scenes.pixels("<scene>" + lit + unlit + "</scene>", look);
        // Looking along +z, x grows to the left.
        int row = SIZE / 2 * SIZE;
        int perUnit = (int) (SIZE / 2 / Math.tan(Math.toRadians(22.5)) / 3.75);
        assertEquals(0xffffff, pixels[row + SIZE / 2 + perUnit], "in the group");
        assertEquals(0xffffff, pixels[row + SIZE / 2 + (int) (0.4 * perUnit)], "below it");
        assertEquals(0, pixels[row + SIZE / 2 - perUnit], "beside it");
    }

    @Test
    void anyNumberOfLightsAddsUp() {
        StringBuilder lights = new StringBuilder();
        for (int i = 0; i < 100; i++) {
            lights.append("<light type='directional' posx='0' posy='0' posz='-1'/>");
        }
        String scene = "<scene><group><lights>" + lights + "</lights><group><translate z='3'/><models><model"
                + " file='box_1_1.3d' diffR='0.004' diffG='0.002'"
                + " diffB='0'/></models></group></group></scene>";
        var look = SceneAppearance.USUAL.with(EnumSet.of(LightTerm.DIFFUSE));
        int rgb = centre(scenes.pixels(scene, look));
        assertEquals(102, channel(rgb, 0), 1);
        assertEquals(51, channel(rgb, 1), 1);
    }

    @Test
    void theBackgroundFillsWhatTheSceneLeaves() {
        var source = scenes.source(world(group("", model("box_1_1.3d", WHITE_AMBIENT))));
        var look = SceneAppearance.USUAL.with(EnumSet.of(LightTerm.AMBIENT));
        int[] pixels = scenes.pixels(new Sources(source, null, DrawnScenes.plain(0x123456)), look);
        assertEquals(0xffffff, centre(pixels));
        assertEquals(0x123456, pixels[0]);
        assertEquals(0x123456, pixels[SIZE * SIZE - 1]);
    }

    /** The entity has its given pose, and every light of the scene reaches it. */
    @Test
    void anEntityIsLitByTheSceneAroundIt() {
        var entity = scenes.source(
                "<scene><group><models><model file='box_1_1.3d' diffR='1' diffG='0.5'/></models></group></scene>");
        String dark = "<scene><group><translate x='50'/><models><model file='box_1_1.3d'/></models></group></scene>";
        String lit = dark.replace(
                "<models>", "<lights><light type='directional' posx='0' posy='0' posz='-1'/></lights><models>");
        var look = SceneAppearance.USUAL.with(EnumSet.of(LightTerm.DIFFUSE));
        int rgb = centre(scenes.pixels(new Sources(scenes.source(lit), entity, null), look));
        assertEquals(255, channel(rgb, 0));
        assertEquals(128, channel(rgb, 1), 1);
        assertEquals(0, centre(scenes.pixels(new Sources(scenes.source(dark), entity, null), look)));
    }

    @Test
    void whatCannotBeShownIsComplainedOfOnceWithItsLine() {
        String scene = world("\n<group><models>\n<model file='ship.3d'/><model file='ship.3d'/>\n"
                + "<model file='box_1_1.3d'><texture file='none.png'/></model></models></group>");
        assertTrue(drawn(scenes.pixels(scene, SceneAppearance.USUAL)) > 300, "the rest is shown");
        assertEquals(2, scenes.complaints.size(), scenes.complaints.toString());
        assertTrue(scenes.complaints.get(0).startsWith("test.xml:3: ship.3d: "), scenes.complaints.get(0));
        assertTrue(scenes.complaints.get(1).startsWith("test.xml:4: none.png: "), scenes.complaints.get(1));
    }

    /** Two meshes, each mirrored or not, take four draws for a hundred models, and the bare twin draws the same. */
    @Test
    void theBareTwinDrawsTheSamePictureByOneDrawAKind() {
        StringBuilder groups = new StringBuilder();
        for (int i = 0; i < 100; i++) {
            String scale = i % 3 == 0 ? "<scale x='-0.1' y='0.1' z='0.1'/>" : "<scale x='0.1' y='0.2' z='0.1'/>";
            groups.append(group(
                    "<translate x='" + (i % 10 - 5) / 5.0 + "' y='" + (i / 10 - 5) / 5.0 + "' z='0'/>" + scale,
                    model(i % 2 == 0 ? "box_1_1.3d" : "sphere_1_8_8.3d", "")));
        }
        var sources = new Sources(scenes.source(world(LIGHT + groups)), null, null);
        try (var drawing = FixedSceneDrawing.load(scenes.gl, sources)) {
            scenes.draw(drawing, sources, SceneAppearance.USUAL, 0);
            int[] engine = scenes.pixels();
            scenes.gl.state().resetCounts();
            try (var bare =
                    BareFrame.record(scenes.gl, () -> scenes.draw(drawing, sources, SceneAppearance.USUAL, 0))) {
                assertEquals(4, scenes.gl.state().draws());
                scenes.picture.clear(1, 0, 1);
                bare.draw();
                assertArrayEquals(engine, scenes.pixels());
            }
        }
        assertEquals(List.of(), scenes.complaints);
    }

    /** With moving models and lights, an entity and a background, a warmed-up frame allocates at most 2 KiB. */
    @Test
    void framesAllocateNextToNothingAndLeaveNothingOnTheGpu() {
        String moving = "<group><transform><rotate time='3' x='0' y='1' z='0'/><translate time='9'><point x='0' y='0'"
                + " z='0'/><point x='1' y='0' z='0'/><point x='1' y='1' z='0'/><point x='0' y='1'"
                + " z='0'/></translate></transform>"
                + "<models>" + model("box_1_1.3d", "").repeat(300) + "</models></group>";
        var source = scenes.source(world(LIGHT + moving));
        var sources = new Sources(source, source, DrawnScenes.plain(0x123456));
        var before = scenes.gl.live().counts();
        try (var drawing = FixedSceneDrawing.load(scenes.gl, sources)) {
            var view = FixedSceneDrawing.view(source.scene().eye(), 1);
            var place = new Matrix4d();
            var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
            long start = 0;
            for (int frame = -100; frame < 100; frame++) {
                start = frame == 0 ? threads.getCurrentThreadAllocatedBytes() : start;
                drawing.draw(view, frame / 60.0, place, SceneAppearance.USUAL.withAxes(true), scenes.picture);
            }
            long perFrame = (threads.getCurrentThreadAllocatedBytes() - start) / 100;
            assertTrue(perFrame <= 2048, perFrame + " bytes a frame");
        }
        assertEquals(before, scenes.gl.live().counts());
    }
}
