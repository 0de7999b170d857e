package nephele.app.window;

import java.util.ArrayList;
import java.util.List;
import org.lwjgl.glfw.GLFWErrorCallback;

/** What the window system said went wrong. */
final class Complaints extends GLFWErrorCallback {
    private final List<String> texts = new ArrayList<>();

    @Override
    public void invoke(int error, long description) {
        texts.add(getDescription(description));
    }

    String text() {
        return texts.isEmpty() ? "the system gives no reason" : String.join("; ", texts);
    }
}
