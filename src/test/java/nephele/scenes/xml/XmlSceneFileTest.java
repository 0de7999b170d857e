package nephele.scenes.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlGroup.Step;
import nephele.scenes.xml.XmlScene.XmlWarning;
import org.junit.jupiter.api.Test;

class XmlSceneFileTest {
    static XmlScene read(String text) {
        return XmlSceneFile.read("x.xml", text.getBytes(StandardCharsets.UTF_8));
    }

    private static List<Integer> warnedLines(XmlScene scene) {
        return scene.warnings().stream().map(XmlWarning::line).toList();
    }

    @Test
    void aWorldIsReadWithAllItSays() {
        XmlScene scene = read(
                """
                \uFEFF<?xml version="1.0" encoding="utf-8"?>
                <world>
                  <window width="640" height="480"/>
                  <camera>
                    <position x="3" y="2" z="1"/> <lookAt x="0" y="1" z="0"/> <up x="0" y="0" z="1"/>
                    <projection fov="50" near="0.5" far="90"/>
                  </camera>
                  <lights>
                    <light type="Point" posx="2" posY="3" posz="-2"/>
                    <light type="directional" dirX="1" dirY="2" dirZ="3"/>
                    <light type="spotlight" posx="1" dirY="-1" cutoff="30" exponent="4"/>
                  </lights>
                  <group>
                    <transform>
                      <scale x="2" y="2" z="2"/>
                      <translate time="10" align="True"> <!-- loop -->
                        <Point x="0" y="0" z="4"/> <point x="4" y="0" z="0"/>
                        <point x="0" y="0" z="-4"/> <point x="-4" y="10" z="0"/>
                      </translate>
                      <rotate angle="-90" x="1" y="0" z="0"/>
                      <rotate time="5" x="0" y="1" z="0"/>
                    </transform>
                    <models>
                      <model file="sphere_1_8_8.3d">
                        <texture file="earth.jpg"/>
                        <color>
                          <diffuse R="255" G="0" B="51"/> <ambient R="0" G="8" B="18"/>
                          <specular R="255" G="255" B="255"/> <shininess value="128"/>
                        </color>
                      </model>
                      <model file="box_2_3.3d"/>
                    </models>
                  </group>
                </world>
                """);
        assertEquals(List.of(), scene.warnings());
        assertEquals(Dialect.WORLD, scene.dialect());
        assertEquals(new XmlScene.Window(640, 480), scene.window());
        Vec3 z = new Vec3(0, 0, 1);
        assertEquals(new XmlScene.Eye(new Vec3(3, 2, 1), new Vec3(0, 1, 0), z, 50, 0.5, 90), scene.eye());
        assertEquals(
                List.of(
                        new XmlLight.Point(new Vec3(2, 3, -2)),
                        new XmlLight.Directional(new Vec3(1, 2, 3)),
                        new XmlLight.Spot(new Vec3(1, 0, 0), new Vec3(0, -1, 0), 30, 4)),
                scene.lights());
        XmlGroup group = scene.root().groups().get(0);
        assertEquals(
                List.of(
                        new Step.Scale(new Vec3(2, 2, 2)),
                        new Step.Follow(
                                10,
                                List.of(new Vec3(0, 0, 4), new Vec3(4, 0, 0), new Vec3(0, 0, -4), new Vec3(-4, 10, 0)),
                                true),
                        new Step.Rotate(new Vec3(1, 0, 0), -90),
                        new Step.Spin(new Vec3(0, 1, 0), 5)),
                group.steps());
        XmlModel.Colours colours = new XmlModel.Colours(
                new Vec3(1, 0, 0.2), new Vec3(0, 8.0 / 255, 18.0 / 255), new Vec3(1, 1, 1), Vec3.ZERO, 128);
        assertEquals(
                new XmlModel(24, "sphere_1_8_8.3d", "earth.jpg", colours),
                group.models().get(0));
        Vec3 grey = new Vec3(200.0 / 255, 200.0 / 255, 200.0 / 255);
        assertEquals(grey, group.models().get(1).colours().diffuse());
    }

    @Test
    void aSceneIsReadAsTheReportWritesIt() {
        XmlScene scene = read(
                """
                <scene>
                 <group>
                  <rotate axisY=1 time=20>
                  <translate x=5 z=2.5>
                  <lights> <light type="point" posx=1> </lights>
                  <models>
                   <model file="sphere.3d" texture="sun.jpg" diffR=1 ambtr=0.5 ambtg=.25 shininess=10>
                  <models>
                  <group>
                   <translate y=1 time=4> <point x=1/> <point y=1/> <point z=1/> <point x=2/> </translate>
                   <models> <model file='a b.3d' /> </models>
                  </group>
                 </group>
                </scene>
                """);
        XmlGroup group = scene.root().groups().get(0);
        assertEquals(
                List.of(new Step.Spin(new Vec3(0, 1, 0), 20), new Step.Translate(new Vec3(5, 0, 2.5))), group.steps());
        assertEquals(List.of(new XmlLight.Point(new Vec3(1, 0, 0))), group.lights());
        XmlModel model = group.models().get(0);
        assertEquals("sun.jpg", model.texture());
        assertEquals(new Vec3(1, 0, 0), model.colours().diffuse());
        assertEquals(new Vec3(0.5, 0.25, 0), model.colours().ambient());
        assertEquals(Vec3.ZERO, model.colours().specular());
        assertEquals("a b.3d", group.groups().get(0).models().get(0).file());
        assertEquals(1, group.groups().get(0).steps().size());
        String warnings = scene.warnings().toString();
        for (String name : List.of("rotate", "translate", "model", "models", "light")) {
            assertTrue(warnings.contains("<" + name + "> is not closed"), name + " in " + warnings);
        }
        assertTrue(warnedLines(scene).stream().allMatch(line -> line >= 3 && line <= 10), warnings);
    }

    @Test
    void namesOfFilesMayBeWrittenAsOnAnySystem() {
        XmlModel model = read("<scene><model file='.\\models\\a.3d' texture='./t.png'/></scene>")
                .root()
                .models()
                .get(0);
        assertEquals("models/a.3d", model.file());
        assertEquals("t.png", model.texture());
    }

    @Test
    void aWorldWithoutCameraWindowAndColoursHasTheCoursesOwn() {
        XmlScene scene = read("<WORLD><Group><Models><Model File='a.3d'><color/></Model></Models></Group></WORLD>");
        assertEquals(List.of(), scene.warnings());
        assertEquals(new XmlScene.Window(512, 512), scene.window());
        assertEquals(new XmlScene.Eye(new Vec3(5, 5, 5), Vec3.ZERO, new Vec3(0, 1, 0), 60, 1, 1000), scene.eye());
        XmlModel.Colours colours = scene.root().groups().get(0).models().get(0).colours();
        assertEquals(200.0 / 255, colours.diffuse().x());
        assertEquals(50.0 / 255, colours.ambient().z());
        assertEquals(Vec3.ZERO, colours.emissive());
    }

    @Test
    void aSceneHasTheReportsEyeAndFixedFunctionOpenGlsLook() {
        XmlScene scene = read("<scene><models><model file='a.3d'/></models></scene>");
        assertEquals(new XmlScene.Window(800, 600), scene.window());
        assertEquals(new XmlScene.Eye(Vec3.ZERO, new Vec3(0, 0, 1), new Vec3(0, 1, 0), 45, 1, 1000), scene.eye());
        Vec3 light = new Vec3(0.8, 0.8, 0.8);
        Vec3 dark = new Vec3(0.2, 0.2, 0.2);
        assertEquals(
                new XmlModel.Colours(light, dark, Vec3.ZERO, Vec3.ZERO, 0),
                scene.root().models().get(0).colours());
    }
}
