package nephele.scenes.xml;

import static nephele.scenes.xml.XmlSceneFileTest.read;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.rule.LevelRules;
import nephele.scenes.xml.LevelDraft.Part;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class LevelDraftTest {
    private static final Aabb CUBE = Aabb.around(Vec3.ZERO, new Vec3(2, 2, 2));
    private static final Vec3 TINT = new Vec3(0.5, 1, 0.25);
    private static final String SOMETHING = "<models><model file='a.3d'/></models>";

    private static LevelDraft draft(XmlScene scene) {
        PosedScene posed = PosedScene.of(scene);
        List<Part> parts = new ArrayList<>();
        for (int i = 0; i < posed.modelCount(); i++) {
            boolean missing = posed.model(i).file().equals("missing.3d");
            parts.add(
                    missing
                            ? null
                            : new Part(posed.model(i).file(), posed.model(i).texture(), TINT, CUBE));
        }
        return LevelDraft.of("test", scene, parts);
    }

    /** Returns the pose that a level's reader derives: parents' frames, then the steps, the first one outermost. */
    private static Matrix4d worldFromModel(Level level, String id) {
        Map<String, Matrix4d> frames = new HashMap<>();
        for (ModelPlacement model : level.models()) {
            Matrix4d frame = model.parent() == null ? new Matrix4d() : new Matrix4d(frames.get(model.parent()));
            for (TransformStep step : model.transform()) {
                if (step instanceof TransformStep.Translate translate) {
                    frame.translate(translate.by().toVector());
                } else if (step instanceof TransformStep.Scale scale) {
                    frame.scale(scale.by().toVector());
                } else if (step instanceof TransformStep.Rotate rotate) {
                    frame.rotate(
                            Math.toRadians(rotate.angleDegrees()),
                            rotate.axis().toVector().normalize());
                }
            }
            frames.put(model.id(), frame);
        }
        return frames.get(id);
    }

    @Test
    void everyModelStandsWhereTheScenePutsItAtTimeZero() {
        XmlScene scene = read("<world><group><transform><translate x='1' y='2' z='3'/><rotate angle='30' x='1' y='1'"
                + " z='0'/></transform><group><transform><scale x='2' y='-3' z='1'/></transform><models><model"
                + " file='missing.3d'/><model file='a.3d'/><model"
                + " file='b.3d'/></models><group><transform><translate time='9' align='true'><point x='1'"
                + " y='5'/><point x='4'/><point z='7'/><point y='1'/></translate><rotate time='4' x='0' y='1'"
                + " z='0'/></transform><models><model file='c.3d'/></models></group></group><models><model"
                + " file='d.3d'/></models></group><models><model file='e.3d'/></models></world>");
        PosedScene posed = PosedScene.of(scene);
        LevelDraft draft = draft(scene);
        List<String> placed =
                draft.level().models().stream().map(ModelPlacement::file).toList();
        List<String> inScene = new ArrayList<>();
        int kept = 0;
        for (int i = 0; i < posed.modelCount(); i++) {
            if (!posed.model(i).file().equals("missing.3d")) {
                Matrix4d placement = worldFromModel(
                        draft.level(), draft.level().models().get(kept++).id());
                inScene.add(posed.model(i).file());
                for (Vector3d corner : List.of(new Vector3d(), new Vector3d(1, 2, 3), new Vector3d(-4, 0, 1))) {
                    Vector3d wanted = posed.worldFromModel(i).transformPosition(corner, new Vector3d());
                    assertEquals(0, placement.transformPosition(corner).distance(wanted), 1e-9);
                }
            }
        }
        assertEquals(inScene, placed);
        assertTrue(
                draft.warnings().toString().contains("time 0"), draft.warnings().toString());
    }

    @Test
    void groupsAreParents() {
        Level level = draft(
                        read("<scene><group><translate x='1'/><models><model file='a.3d'/><model file='b.3d'/></models>"
                                + "<group><translate y='1'/><group><scale x='2' y='2' z='2'/>" + SOMETHING
                                + "</group></group></group></scene>"))
                .level();
        assertEquals(1, level.models().get(0).transform().size());
        assertNull(level.models().get(0).parent());
        assertEquals("model-1", level.models().get(1).parent());
        assertEquals(List.of(), level.models().get(1).transform());
        assertEquals("model-1", level.models().get(2).parent());
        assertEquals(2, level.models().get(2).transform().size());
    }

    @Test
    void displayColoursBecomeLinearOnesAndShininessRoughness() {
        Level level = draft(read("<scene><models><model file='a.3d' texture='t.png' diffR='0.5' diffG='1'"
                        + " emisB='1'/><model file='b.3d' specR='1' shininess='30'/><model file='c.3d'"
                        + " specR='1' shininess='30'/></models></scene>"))
                .level();
        Material first = level.materials().get(0);
        assertEquals(0.21404, first.baseColour().x(), 1e-5);
        assertEquals(1, first.baseColour().y());
        assertEquals(new Vec3(0, 0, 0.25), first.emission());
        assertEquals("t.png", first.texture());
        assertTrue(first.lambert());
        assertEquals(Math.pow(2 / 32.0, 0.25), level.materials().get(1).roughness());
        assertEquals(level.models().get(1).material(), level.models().get(2).material());
    }

    @Test
    void lightsAreAsBrightAsTheyWereAtTheModelsDistance() {
        Level level = draft(read("<scene><group><translate y='5'/><lights><light type='point' posy='-2'/><light"
                        + " type='spot' spotdiry='-1' cutoff='40' exponent='2'/><light type='directional' posx='3'/>"
                        + "</lights></group>" + SOMETHING + "</scene>"))
                .level();
        Light.Point point = assertInstanceOf(Light.Point.class, level.lights().get(0));
        assertEquals(new Vec3(0, 3, 0), point.position());
        assertEquals(Math.PI * 9, point.radiantIntensity().x(), 1e-9);
        Light.Spot spot = assertInstanceOf(Light.Spot.class, level.lights().get(1));
        assertEquals(40, spot.outerConeDegrees());
        assertEquals(new Vec3(0, -1, 0), spot.direction());
        assertEquals(new Vec3(1, 0, 0), level.environment().sun().directionTowardsSun());
    }

    @Test
    void aLightInAModelShinesOutOfIt() {
        Level level = draft(
                        read("<scene><lights><light type='point' posx='0.9'/><light type='point' posx='1.1'/></lights>"
                                + SOMETHING + "</scene>"))
                .level();
        assertFalse(level.lights().get(0).castsShadow());
        assertTrue(level.lights().get(1).castsShadow());
    }

    /** A plain of 60 m below the camera, a wider hill in view, and a hill behind the camera that is higher. */
    @Test
    void thePlayerStartsAboveTheHighestGroundInView() {
        Level level = draft(read("<world><camera><position x='0' y='9' z='0'/><lookAt x='0' y='0' z='-9'/></camera>"
                        + wide(0, -4, 0, 30) + wide(0, -2, -18, 4) + wide(0, 1, 18, 4) + "</world>"))
                .level();
        assertEquals(new Vec3(0, -0.98, -18), level.player().feet());
        Solid.Box floor = (Solid.Box) level.solids().get(0);
        assertFalse(floor.portalable());
        assertEquals(-5.02, floor.centre().y() + floor.size().y() / 2, 1e-9);
        assertEquals(new Sky.Constant(Vec3.ZERO), level.environment().sky());
    }

    private static String wide(double x, double y, double z, double half) {
        return "<group><transform><translate x='" + x + "' y='" + y + "' z='" + z + "'/><scale x='" + half
                + "' y='1' z='" + half + "'/></transform>" + SOMETHING + "</group>";
    }

    @Test
    void theFloorIsBelowEverythingAndThePlayerOnItBesideEverything() {
        Level level = draft(read("<world><camera><position x='0' y='9' z='1'/></camera><group><transform>"
                        + "<translate x='0' y='-4' z='0'/><scale x='1.5' y='30' z='30'/></transform>" + SOMETHING
                        + "</group></world>"))
                .level();
        Solid.Box floor = (Solid.Box) level.solids().get(0);
        double top = floor.centre().y() + floor.size().y() / 2;
        assertEquals(-34.02, top, 1e-9);
        assertTrue(floor.portalable());
        Vec3 feet = level.player().feet();
        assertEquals(top, feet.y(), 1e-9);
        assertTrue(Math.max(Math.abs(feet.x()), Math.abs(feet.z())) > 31, feet.toString());
        assertTrue(Math.abs(feet.x() - floor.centre().x()) < floor.size().x() / 2 - 1);
        assertTrue(Math.abs(feet.z() - floor.centre().z()) < floor.size().z() / 2 - 1);
        assertEquals(9, level.cameras().get(0).position().y());
    }

    /** From groups ten thousand deep, flat, enormous or spinning in place, the draft makes a level that reads back. */
    @Test
    void whatALevelCannotHoldIsLeftOutAndTold() {
        String deep = "<group><translate x='1'/>".repeat(3000) + SOMETHING + "</group>".repeat(3000);
        String chain = ("<group><translate x='1'/>" + SOMETHING).repeat(3000) + "</group>".repeat(3000);
        String flat = "<group><scale x='1' y='1'/>" + SOMETHING + "</group>";
        String far = "<group><translate x='1e9'/>" + SOMETHING + "</group>";
        LevelDraft draft = draft(read("<scene>" + deep + chain + flat + far + SOMETHING + "</scene>"));
        assertEquals(3001, draft.level().models().size());
        assertEquals(
                3,
                draft.warnings().stream()
                        .filter(w -> w.message().contains("left out"))
                        .count());
        byte[] text = LevelJson.write(draft.level()).getBytes(java.nio.charset.StandardCharsets.UTF_8);
        assertEquals(draft.level(), LevelJson.read("level.json", text));
        var problems = LevelRules.checkRecords(draft.level());
        assertTrue(problems.stream().noneMatch(problem -> problem.isError()), problems.toString());
    }
}
