package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** The rectangle of pixels outside of which nothing changes; calls OpenGL only for what differs. */
final class Scissor {
    /** Whether the test is on; {@code null} when that is not known. */
    private Boolean on = false;

    private int x;
    private int y;
    private int width;
    private int height;

    void keepTo(int newX, int newY, int newWidth, int newHeight) {
        if (on != Boolean.TRUE) {
            glEnable(GL_SCISSOR_TEST);
            on = true;
        }
        if (x != newX || y != newY || width != newWidth || height != newHeight) {
            glScissor(newX, newY, newWidth, newHeight);
            x = newX;
            y = newY;
            width = newWidth;
            height = newHeight;
        }
    }

    void off() {
        if (on != Boolean.FALSE) {
            glDisable(GL_SCISSOR_TEST);
            on = false;
        }
    }

    void assumeNothing() {
        on = null;
        width = -1;
    }
}
