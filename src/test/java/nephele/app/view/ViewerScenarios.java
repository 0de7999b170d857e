package nephele.app.view;

import static org.lwjgl.glfw.GLFW.*;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import nephele.app.window.GameWindow;
import nephele.app.window.Size;
import nephele.engine.level.Language;
import nephele.engine.render.gl.GlContext;
import nephele.scenes.file.OpenedScene;
import nephele.scenes.file.SceneName;
import nephele.scenes.fixed.SceneAppearance;
import nephele.scenes.fixed.Shading;
import nephele.scenes.view.SceneStart;
import nephele.scenes.view.ThirdPersonCamera;
import nephele.scenes.view.ViewerAngles;

/**
 * The viewer in a real window, run by {@link SceneViewerSwingTest} in a process that has a display. Prints a line for
 * each scenario: its name and "ok", or the failure.
 */
public final class ViewerScenarios {
    private static final int MOST_FRAMES = 400;

    private final ViewerInput input = new ViewerInput();
    private final GameWindow window = GameWindow.open("Viewer test", new Size(320, 240), input);
    private final long handle = glfwGetCurrentContext();
    private final GlContext gl = GlContext.ofCurrent();
    private final Map<?, Integer> baseline = gl.live().counts();
    private final SceneViewer viewer;

    private ViewerScenarios(String scene, String entity) {
        var opened = OpenedScene.of(new SceneName(scene), new SceneName(entity), null, System.out::println);
        viewer = new SceneViewer(new SceneStart(opened, SceneAppearance.USUAL, 0), window, input, gl, Language.EN);
    }

    /** An action, and a condition that must hold within a number of frames. */
    private record Scenario(String name, Runnable act, BooleanSupplier holds) {}

    public static void main(String[] args) {
        var scenarios = new ViewerScenarios(args[0], args[1]);
        for (var scenario : scenarios.all()) {
            System.out.println(scenario.name + ": " + scenarios.outcome(scenario));
        }
        scenarios.finish();
    }

    private List<Scenario> all() {
        return List.of(
                new Scenario("begins when it is loaded", () -> {}, () -> seconds() == 0),
                new Scenario("starts", () -> {}, () -> isSize(320, 240) && seconds() > 0),
                new Scenario(
                        "turns", () -> press(GLFW_KEY_LEFT), () -> heading().yawDegrees() == 5),
                new Scenario(
                        "looks down", () -> press(GLFW_KEY_UP), () -> heading().pitchDegrees() == -5),
                new Scenario("is dragged", this::drag, () -> heading().yawDegrees() == -5),
                new Scenario(
                        "moves alone",
                        () -> input.key(GLFW_KEY_D, true),
                        () -> place().spring().currentRight() > 0),
                new Scenario(
                        "takes the camera along", () -> {}, () -> place().eye().x() < -0.5),
                new Scenario("rests again", () -> input.key(GLFW_KEY_D, false), () -> place().bankDegrees() == 0),
                new Scenario("shows wires", () -> press(GLFW_KEY_F1), () -> look().shading() == Shading.WIREFRAME),
                new Scenario("shows axes", () -> press(GLFW_KEY_F2), () -> look().axes()),
                new Scenario("resizes", () -> glfwSetWindowSize(handle, 500, 260), () -> isSize(500, 260)),
                new Scenario("shrinks to a line", () -> glfwSetWindowSize(handle, 300, 1), () -> isSize(300, 1)),
                new Scenario("fills the screen", () -> press(GLFW_KEY_F11), () -> isSize(1024, 600)),
                new Scenario("takes a picture", () -> press(GLFW_KEY_F12), ViewerScenarios::hasPicture),
                new Scenario("leaves", () -> press(GLFW_KEY_ESCAPE), viewer::isLeaving));
    }

    private String outcome(Scenario scenario) {
        scenario.act.run();
        for (int frame = 0; frame < MOST_FRAMES; frame++) {
            viewer.frame();
            gl.requireNoError(scenario.name);
            if (scenario.holds.getAsBoolean()) {
                return "ok";
            }
        }
        return "not after " + MOST_FRAMES + " frames; size " + window.width() + "x" + window.height() + ", " + place();
    }

    private void finish() {
        viewer.close();
        boolean nothingLeft = gl.live().counts().equals(baseline);
        System.out.println(
                "leaves nothing behind: " + (nothingLeft ? "ok" : gl.live().counts()));
        gl.close();
        window.close();
    }

    private void press(int code) {
        input.key(code, true);
        input.key(code, false);
    }

    private void drag() {
        input.point(10, 10);
        input.click();
        input.point(30, 10);
        input.letGo();
    }

    private ThirdPersonCamera place() {
        return viewer.viewing().place();
    }

    private ViewerAngles heading() {
        return place().heading();
    }

    private SceneAppearance look() {
        return viewer.viewing().look();
    }

    private double seconds() {
        return viewer.viewing().sceneSeconds();
    }

    private boolean isSize(int width, int height) {
        return window.width() == width && window.height() == height;
    }

    private static boolean hasPicture() {
        var pictures = Path.of("pictures").toFile().list();
        return pictures != null && pictures.length == 1;
    }
}
