package nephele.app.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.HashSet;
import java.util.Set;
import nephele.engine.level.Language;
import nephele.engine.math.Vec3;
import nephele.scenes.fixed.SceneAppearance;
import nephele.scenes.fixed.Shading;
import nephele.scenes.view.ViewerKey;
import nephele.scenes.view.ViewerState;
import nephele.scenes.xml.XmlScene;
import org.junit.jupiter.api.Test;
import org.lwjgl.glfw.GLFW;

/** Window events become the input that the viewer queries. */
class ViewerInputTest {
    private final ViewerInput input = new ViewerInput();

    @Test
    void aKeyThatWasStruckBetweenTwoFramesIsHeldForOne() {
        input.key(GLFW.GLFW_KEY_W, true);
        input.key(GLFW.GLFW_KEY_W, false);
        input.key(GLFW.GLFW_KEY_D, true);
        assertEquals(Set.of(ViewerKey.AHEAD, ViewerKey.RIGHT), input.takeHeld());
        assertEquals(Set.of(ViewerKey.RIGHT), input.takeHeld());
    }

    @Test
    void onlyTurnsRepeat() {
        input.key(GLFW.GLFW_KEY_LEFT, true);
        input.repeated(GLFW.GLFW_KEY_LEFT);
        input.repeated(GLFW.GLFW_KEY_F1);
        assertEquals(ViewerKey.TURN_LEFT, input.nextPressed());
        assertEquals(ViewerKey.TURN_LEFT, input.nextPressed());
        assertNull(input.nextPressed());
    }

    @Test
    void thePointerTurnsOnlyWhileItsButtonIsDown() {
        input.point(10, 10);
        input.point(50, 10);
        input.click();
        input.point(53, 14);
        input.point(55, 15);
        input.letGo();
        input.point(500, 500);
        assertEquals(5, input.takeDraggedRight());
        assertEquals(5, input.takeDraggedDown());
        assertEquals(0, input.takeDraggedRight());
    }

    @Test
    void nothingIsHeldAfterTheFocusWent() {
        input.key(GLFW.GLFW_KEY_W, true);
        input.click();
        input.point(5, 5);
        input.forget();
        input.point(50, 50);
        assertEquals(Set.of(), input.takeHeld());
        assertEquals(0, input.takeDraggedRight());
        assertNull(input.nextPressed());
    }

    @Test
    void noCodeHasTwoMeanings() {
        var seen = new HashSet<ViewerKey>();
        for (int code = 0; code <= GLFW.GLFW_KEY_LAST; code++) {
            var key = ViewerKey.of(code);
            if (key != null) {
                seen.add(key);
            }
        }
        assertEquals(Set.of(ViewerKey.values()), seen);
        input.key(-1, true);
        assertNull(input.nextPressed());
    }

    @Test
    void whatAKeyChangesIsToldInWordsWhereThePictureDoesNotShowIt() {
        var viewing = ViewerState.alone(
                new XmlScene.Eye(Vec3.ZERO, new Vec3(0, 0, 1), new Vec3(0, 1, 0), 45, 1, 1000),
                SceneAppearance.USUAL.with(Shading.PHONG),
                0);
        assertEquals("Shading: Phong", change(ViewerKey.SHADING, viewing));
        assertEquals("Light: ambient, diffuse, specular, emissive", change(ViewerKey.DIFFUSE, viewing));
        assertEquals("", change(ViewerKey.AXES, viewing));
    }

    private static String change(ViewerKey key, ViewerState viewing) {
        return SceneViewer.change(key, viewing, Language.EN).orElse("");
    }
}
