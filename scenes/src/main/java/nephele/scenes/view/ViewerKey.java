package nephele.scenes.view;

import static org.lwjgl.glfw.GLFW.*;

import java.util.List;
import nephele.scenes.fixed.LightTerm;

/** The keys of the viewer. */
public enum ViewerKey {
    AHEAD(GLFW_KEY_W),
    BACK(GLFW_KEY_S),
    LEFT(GLFW_KEY_A),
    RIGHT(GLFW_KEY_D),
    FASTER(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
    TURN_LEFT(GLFW_KEY_LEFT),
    TURN_RIGHT(GLFW_KEY_RIGHT),
    /** The vertical arrow keys are inverted, as with a flight stick. */
    LOOK_DOWN(GLFW_KEY_UP),
    LOOK_UP(GLFW_KEY_DOWN),
    WIREFRAME(GLFW_KEY_F1),
    AXES(GLFW_KEY_F2),
    SHADING(GLFW_KEY_F3),
    AMBIENT(GLFW_KEY_1),
    DIFFUSE(GLFW_KEY_2),
    SPECULAR(GLFW_KEY_3),
    EMISSIVE(GLFW_KEY_4),
    PAUSE(GLFW_KEY_SPACE),
    HOME(GLFW_KEY_R),
    KEYS(GLFW_KEY_H),
    FULL_SCREEN(GLFW_KEY_F11),
    SCREENSHOT(GLFW_KEY_F12),
    LEAVE(GLFW_KEY_ESCAPE);

    private final List<Integer> codes;

    ViewerKey(Integer... codes) {
        this.codes = List.of(codes);
    }

    /** Returns the key with a GLFW code; {@code null} for keys without a function. */
    public static ViewerKey of(int code) {
        for (var key : values()) {
            if (key.codes.contains(code)) {
                return key;
            }
        }
        return null;
    }

    /** Returns true if each repeat of the held key counts as a press. */
    public boolean repeats() {
        return switch (this) {
            case TURN_LEFT, TURN_RIGHT, LOOK_DOWN, LOOK_UP -> true;
            default -> false;
        };
    }

    /** Returns the term of the lighting model that the key toggles; {@code null} for other keys. */
    LightTerm term() {
        return switch (this) {
            case AMBIENT -> LightTerm.AMBIENT;
            case DIFFUSE -> LightTerm.DIFFUSE;
            case SPECULAR -> LightTerm.SPECULAR;
            case EMISSIVE -> LightTerm.EMISSIVE;
            default -> null;
        };
    }
}
