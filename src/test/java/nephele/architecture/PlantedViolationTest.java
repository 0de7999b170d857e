package nephele.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchRule;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Every rule finds the violation that is planted for it; a rule that cannot fail is a defect. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class PlantedViolationTest {
    private final Map<String, String> planted = new TreeMap<>();
    private JavaClasses classes;

    @BeforeAll
    void compilePlantedClasses(@TempDir Path folder) throws IOException {
        plantPackageViolations();
        plantStyleViolations();
        plantIndeterminism();
        List<String> arguments = new ArrayList<>(
                List.of("-proc:none", "-nowarn", "-d", folder.resolve("out").toString()));
        for (var file : planted.entrySet()) {
            Path path = folder.resolve(file.getKey().replace('.', '/') + ".java");
            Files.createDirectories(path.getParent());
            Files.writeString(path, file.getValue());
            arguments.add(path.toString());
        }
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, arguments.toArray(String[]::new)));
        classes = new ClassFileImporter().importPath(folder.resolve("out"));
    }

    private void plant(String name, String body) {
        int dot = name.lastIndexOf('.');
        String type = name.substring(dot + 1);
        planted.put(name, "package " + name.substring(0, dot) + "; public class " + type + " {" + body + "}");
    }

    private void plantPackageViolations() {
        plant("nephele.engine.level.Written", "");
        plant("nephele.engine.math.SeesLevel", "nephele.engine.level.Written w;");
        plant("nephele.engine.unknown.InNoRow", "");
        plant("nephele.engine.render.pass.fog.SeesSky", "nephele.engine.render.pass.sky.Sky s;");
        plant("nephele.engine.render.pass.sky.Sky", "nephele.engine.render.pass.cloud.Shared s;");
        plant("nephele.engine.render.pass.cloud.Shared", "");
        plant("nephele.engine.choice.Chosen", "");
        plant("nephele.engine.render.frame.SeesChoice", "nephele.engine.choice.Chosen c;");
        plant("nephele.engine.sim.reach.Reach", "");
        plant("nephele.engine.render.pass.fog.SeesSim", "nephele.engine.sim.reach.Reach r;");
        plant("nephele.app.Top", "");
        plant("nephele.editor.SeesApp", "nephele.app.Top t;");
        plant("nephele.lab.SeesApp", "nephele.app.Top t;");
        plant("nephele.engine.scene.SeesEditor", "nephele.editor.SeesApp e;");
        plant("nephele.lab.SeesEditor", "nephele.editor.SeesApp e;");
        plant("nephele.host.playthrough.SeesLab", "nephele.lab.SeesApp l;");
        plant("nephele.app.play.SeesLab", "nephele.lab.SeesApp l;");
        plant("nephele.app.command.SeesLab", "nephele.lab.SeesApp l;");
        plant("nephele.scenes.fixed.Drawing", "");
        plant("nephele.scenes.xml.SeesDrawing", "nephele.scenes.fixed.Drawing d;");
        plant("nephele.editor.SeesScenes", "nephele.scenes.fixed.Drawing d;");
        plant("nephele.app.play.SeesScenes", "nephele.scenes.fixed.Drawing d;");
        plant("nephele.workshop.Proof", "");
        plant("nephele.app.command.SeesWorkshop", "nephele.workshop.Proof p;");
        plant("nephele.editor.pane.SeesLab", "nephele.lab.SeesApp l;");
        plant("nephele.nowhere.InNoModule", "");
        plant("nephele.engine.portal.RoundA", "nephele.engine.cloud.RoundB b;");
        plant("nephele.engine.cloud.RoundB", "nephele.engine.portal.RoundA a;");
        plant("nephele.engine.level.ring.RoundC", "nephele.engine.level.RoundD d;");
        plant("nephele.engine.level.RoundD", "nephele.engine.level.ring.RoundC c;");
        plant("nephele.engine.sim.SeesSwing", "javax.swing.JLabel l;");
        plant("nephele.engine.asset.SeesGlfw", "int i = org.lwjgl.glfw.GLFW.glfwGetTimerFrequency() > 0 ? 1 : 0;");
        plant("nephele.engine.render.SeesFrame", "java.awt.Frame f;");
        plant("nephele.engine.asset.SeesProfile", "java.awt.color.ICC_Profile p;");
        plant("nephele.app.SeesOpenGl", "void f() { org.lwjgl.opengl.GL41C.glFlush(); }");
        plant("nephele.editor.tool.SeesSwing", "javax.swing.JLabel l;");
    }

    private void plantStyleViolations() {
        plant("nephele.engine.level.Counter", "static int count;");
        plant("nephele.engine.level.SolidManager", "");
        planted.put(
                "nephele.engine.level.Child", "package nephele.engine.level; public class Child extends Written {}");
        plant("nephele.engine.level.Flags", "void f(boolean a, int n, boolean b) {}");
        for (int i = 0; i < 61; i++) {
            plant("nephele.engine.model.crowd.Crowd" + i, "");
        }
        plant("nephele.engine.asset.Reads", "public static Reads read(String id, byte[] bytes) { return null; }");
        plant("nephele.engine.model.Twice", "");
        plant("nephele.engine.asset.Twice", "");
    }

    private void plantIndeterminism() {
        plant("nephele.engine.sim.ReadsClock", "long t = System.nanoTime();");
        plant("nephele.engine.sim.Gambles", "double d = Math.random();");
        plant("nephele.engine.collision.TakesSine", "double d = Math.sin(1);");
        plant("nephele.engine.portal.Rotates", "Object q = new org.joml.Quaterniond().rotateX(1);");
        plant("nephele.engine.sim.Hashes", "Object m = new java.util.HashMap<String, String>();");
    }

    static List<String[]> plantedByRule() {
        return List.of(
                new String[] {"engine and scenes use only", "math.SeesLevel"},
                new String[] {"engine and scenes use only", "unknown.InNoRow"},
                new String[] {"engine and scenes use only", "render.frame.SeesChoice"},
                new String[] {"engine and scenes use only", "fog.SeesSim"},
                new String[] {"a pass uses no other pass", "fog.SeesSky"},
                new String[] {"engine and scenes use only", "scenes.xml.SeesDrawing"},
                new String[] {"a module uses only", "editor.SeesApp"},
                new String[] {"a module uses only", "editor.SeesScenes"},
                new String[] {"a module uses only", "lab.SeesApp"},
                new String[] {"a module uses only", "app.command.SeesWorkshop"},
                new String[] {"a module uses only", "pane.SeesLab"},
                new String[] {"a module uses only", "scene.SeesEditor"},
                new String[] {"a module uses only", "lab.SeesEditor"},
                new String[] {"a module uses only", "playthrough.SeesLab"},
                new String[] {"a module uses only", "nowhere.InNoModule"},
                new String[] {"only commands and the viewer", "play.SeesScenes"},
                new String[] {"only commands use the lab", "play.SeesLab"},
                new String[] {"no cycles", "portal.RoundA"},
                new String[] {"no cycles", "level.ring.RoundC"},
                new String[] {"headless packages", "sim.SeesSwing"},
                new String[] {"asset sees", "asset.SeesGlfw"},
                new String[] {"colour profiles are used", "asset.SeesProfile"},
                new String[] {"the renderer opens no window", "render.SeesFrame"},
                new String[] {"raw OpenGL only", "app.SeesOpenGl"},
                new String[] {"editor tools", "tool.SeesSwing"},
                new String[] {"readers refuse", "asset.Reads"},
                new String[] {"no mutable statics", "level.Counter"},
                new String[] {"no names that say nothing", "level.SolidManager"},
                new String[] {"no inheritance", "level.Child"},
                new String[] {"no pairs of boolean", "level.Flags"},
                new String[] {"no package with more than 60", "crowd.Crowd0"},
                new String[] {"no simple name twice", "model.Twice"},
                new String[] {"the simulation calls no a clock", "sim.ReadsClock"},
                new String[] {"unseeded or foreign randomness", "sim.Gambles"},
                new String[] {"a transcendental of Math", "collision.TakesSine"},
                new String[] {"trigonometry of JOML", "portal.Rotates"},
                new String[] {"a collection in hash order", "sim.Hashes"});
    }

    @ParameterizedTest
    @MethodSource("plantedByRule")
    void theRuleFindsWhatIsPlantedForIt(String ruleName, String offender) {
        String report = report(ruleName);
        assertTrue(report.contains(offender), report);
    }

    @Test
    void everyRuleHasAPlantedViolation() {
        List<String> names = plantedByRule().stream().map(pair -> pair[0]).toList();
        ArchitectureTest.rules()
                .forEach(rule ->
                        assertTrue(names.stream().anyMatch(rule.getDescription()::contains), rule.getDescription()));
    }

    @Test
    void theSharedCloudPackageIsExcepted() {
        assertFalse(report("a pass uses no other pass").contains("sky.Sky.s>"));
    }

    @Test
    void commandsMayUseTheLab() {
        assertFalse(report("only commands use the lab").contains("command.SeesLab"));
    }

    private String report(String ruleName) {
        ArchRule rule = ArchitectureTest.rules()
                .filter(r -> r.getDescription().contains(ruleName))
                .findFirst()
                .orElseThrow();
        return rule.evaluate(classes).getFailureReport().toString();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "NOTHING_NEWER_THAN_OPENGL_4_1|engine/src/A.java|import org.lwjgl.%opengl.GL43C;",
                "NOTHING_NEWER_THAN_OPENGL_4_1|engine/src/A.java|import static org.lwjgl.%opengl.GL42C.glTexStorage2D;",
                "NOTHING_NEWER_THAN_OPENGL_4_1|engine/src/A.java|import org.lwjgl.%opengl.ARBClipControl;",
                "GLSL_410|engine/src/a.glsl|#version 430 core",
                "GLSL_410|engine/src/a.glsl|#extension GL_ARB_gpu_shader5 : enable",
                "NO_UNFINISHED_WORK|engine/src/A.java|// TO%DO later",
                "NO_SLEEPS_RETRIES_OR_DISABLED_TESTS|src/test/ATest.java|Thread.%sleep(1);",
                "NO_SLEEPS_RETRIES_OR_DISABLED_TESTS|src/test/ATest.java|@%Disabled",
                "NO_STACK_TRACES_FOR_USERS|app/src/A.java|e.print%StackTrace();",
                "TESTS_ARE_NAMED_BY_TIER|src/test/Checks.java|@Test void f() {}",
                "TESTS_ARE_NAMED_BY_TIER|src/test/EmptyTest.java|class EmptyTest {}",
                "TESTS_ARE_NAMED_BY_TIER|src/test/LightTest.java|@Test void f() { OffscreenContext c; }",
                "TESTS_ARE_NAMED_BY_TIER|src/test/ViewTest.java|import javax.%swing.JFrame; @Test void f() {}",
                "TESTS_ARE_NAMED_BY_TIER|src/test/ViewSwingTest.java|@Test void f() {}",
                "CONCURRENT_TESTS_USE_NO_OPENGL|src/test/LightGlTest.java|@Execution(ExecutionMode.CONCURRENT)",
                "TESTS_THAT_CHANGE_THE_PROCESS_ARE_ISOLATED|src/test/ATest.java|Locale.set%Default(null);",
                "TESTS_THAT_CHANGE_THE_PROCESS_ARE_ISOLATED|src/test/ATest.java|System.set%Out(null);",
                "AT_MOST_800_LINES|engine/src/A.java|%%%"
            })
    void theSourceRuleFindsWhatIsPlantedForIt(SourceRules rule, String path, String text) {
        String planted = text.equals("%%%") ? "\n".repeat(801) : text.replace("%", "");
        assertEquals(1, rule.violations(new SourceFile(path, planted)).size());
        assertEquals(
                List.of(),
                rule.violations(new SourceFile(path, "import org.lwjgl.opengl.GL41C; @Test void f() {}")).stream()
                        .filter(v -> !rule.equals(SourceRules.TESTS_ARE_NAMED_BY_TIER))
                        .toList());
    }

    @Test
    void everySourceRuleIsCompared() {
        assertEquals(9, SourceRules.values().length, "add a planted line above for the new rule");
    }
}
