package nephele.scenes.xml;

import static nephele.scenes.xml.XmlSceneFileTest.read;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlGroup.Step;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class PosedSceneTest {
    private static final double CLOSE = 1e-12;

    static XmlScene scene(XmlGroup root) {
        return new XmlScene(Dialect.SCENE, EyeReader.SCENE_WINDOW, EyeReader.SCENE_EYE, List.of(), root, List.of());
    }

    static XmlModel model(String file) {
        Vec3 one = new Vec3(1, 1, 1);
        return new XmlModel(1, file, null, new XmlModel.Colours(one, one, one, one, 0));
    }

    private static void assertAt(double x, double y, double z, Matrix4dc place, Vector3d point) {
        Vector3d at = place.transformPosition(point);
        assertEquals(0, at.distance(x, y, z), CLOSE, () -> "it is at " + at);
    }

    @Test
    void stepsAreInDocumentOrderTheFirstOneOutermost() {
        PosedScene turnedThenMoved = PosedScene.of(read("<world><group><transform>"
                + "<rotate angle='90' x='0' y='1' z='0'/><translate x='3' y='0' z='0'/><scale x='2' y='1' z='1'/>"
                + "</transform><models><model file='box_2_3.3d'/></models></group></world>"));
        assertAt(0, 0, -5, turnedThenMoved.worldFromModel(0), new Vector3d(1, 0, 0));
        PosedScene movedThenTurned = PosedScene.of(read("<scene><group><scale x='2' y='1' z='1'/>"
                + "<translate x='3'/><rotate angle='90' axisY='1'/><group><translate y='1'/>"
                + "<models><model file='box_2_3.3d'/></models></group></group></scene>"));
        assertAt(6, 1, -1, movedThenTurned.worldFromModel(0), new Vector3d(1, 0, 0));
    }

    @Test
    void aTurnTakesItsTimeAndNeverEndsElsewhere() {
        PosedScene posed = PosedScene.of(
                read("<scene><group><rotate axisZ=2 time=8><models><model file=a.3d></models></group></scene>"));
        assertTrue(posed.moves(0));
        for (double start : new double[] {0, 8e6, -80}) {
            posed.at(start + 2);
            assertAt(0, 1, 0, posed.worldFromModel(0), new Vector3d(1, 0, 0));
            posed.at(start + 1);
            assertAt(Math.sqrt(0.5), Math.sqrt(0.5), 0, posed.worldFromModel(0), new Vector3d(1, 0, 0));
        }
        assertThrows(IllegalArgumentException.class, () -> posed.at(Double.NaN));
    }

    @Test
    void placesDependOnTheTimeAloneHoweverManyFramesCameBefore() {
        String moving = "<world><group><transform><rotate time='7' x='1' y='2' z='3'/><translate time='11'"
                + " align='true'><point x='1'/><point y='2'/><point z='3'/><point"
                + " x='-1'/></translate></transform><models><model file='a.3d'/></models></group></world>";
        PosedScene inOneStep = PosedScene.of(read(moving));
        PosedScene inMany = PosedScene.of(read(moving));
        for (int frame = 1; frame <= 1000; frame++) {
            inMany.at(frame * 0.033);
        }
        inMany.at(123.456);
        inOneStep.at(123.456);
        assertEquals(inOneStep.worldFromModel(0), inMany.worldFromModel(0));
    }

    @Test
    void aWorldsLightsReachEverythingAGroupsThatAndBelow() {
        PosedScene world =
                PosedScene.of(read("<world><lights><light type='point'/><light type='point' posx='1'/></lights>"
                        + "<group><models><model file='a.3d'/></models></group></world>"));
        assertEquals(List.of(1, 0), chain(world, 0));
        PosedScene scene = PosedScene.of(read("<scene><group><lights><light type='point'"
            + " posx='1'/></lights><models><model file='a'/></models>  <group><lights><light type='point'"
            + " posx='2'/></lights><models><model file='b'/></models></group>  <group><translate x='5'/><lights><light"
            + " type='point' posx='3'/></lights><models><model file='c'/></models> "
            + " </group></group><group><models><model file='d'/></models></group></scene>"));
        assertEquals("d", scene.model(3).file());
        assertEquals(List.of(0), chain(scene, 0));
        assertEquals(List.of(1, 0), chain(scene, 1));
        assertEquals(List.of(2, 0), chain(scene, 2));
        assertEquals(List.of(), chain(scene, 3));
        assertAt(
                8,
                0,
                0,
                scene.worldFromLight(2),
                ((XmlLight.Point) scene.light(2)).position().toVector());
    }

    private static List<Integer> chain(PosedScene scene, int model) {
        List<Integer> lights = new java.util.ArrayList<>();
        for (int light = scene.firstLight(model); light != PosedScene.NONE; light = scene.nextLight(light)) {
            lights.add(light);
        }
        return lights;
    }

    @Test
    void groupsMayBeAHundredThousandDeep() {
        XmlGroup group = new XmlGroup(1, List.of(), List.of(), List.of(model("a.3d")), List.of());
        XmlGroup same = new XmlGroup(1, List.of(), List.of(), List.of(model("a.3d")), List.of());
        for (int depth = 0; depth < 100_000; depth++) {
            List<Step> steps = List.of(new Step.Translate(new Vec3(1, 0, 0)));
            List<XmlLight> lights = List.of(new XmlLight.Point(Vec3.ZERO));
            group = new XmlGroup(1, steps, lights, List.of(), List.of(group));
            same = new XmlGroup(1, steps, lights, List.of(), List.of(same));
        }
        PosedScene posed = PosedScene.of(scene(group));
        assertAt(100_000, 0, 0, posed.worldFromModel(0), new Vector3d());
        assertEquals(100_000, chain(posed, 0).size());
        assertEquals(group, same);
        assertEquals(group.hashCode(), same.hashCode());
        assertTrue(group.toString().length() < 1000);
    }

    @Test
    void aFrameAllocatesNothing() {
        PosedScene posed =
                PosedScene.of(read("<world><group><transform><rotate time='7' x='1' y='2' z='3'/><translate time='11'"
                        + " align='true'><point x='1'/><point y='2'/><point z='3'/><point"
                        + " x='-1'/></translate><scale x='2' y='1' z='-1'/><rotate angle='3'"
                        + " x='1'/></transform><models><model file='a.3d'/></models></group></world>"));
        WorldSpheres spheres = new WorldSpheres(1);
        ThreadMXBean memory = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        double start = 0;
        for (int warmUp = 0; warmUp < 20_000; warmUp++) {
            posed.at(start += 0.016);
            spheres.place(0, 1, 2, 3, 4, posed.worldFromModel(0));
        }
        long before = memory.getCurrentThreadAllocatedBytes();
        for (int frame = 0; frame < 10_000; frame++) {
            posed.at(start += 0.016);
            spheres.place(0, 1, 2, 3, 4, posed.worldFromModel(0));
        }
        assertTrue(memory.getCurrentThreadAllocatedBytes() - before < 10_000, "less than a byte a frame");
    }
}
