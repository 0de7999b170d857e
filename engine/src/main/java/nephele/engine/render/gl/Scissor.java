package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** The scissor rectangle; calls OpenGL only for differences. */
final class Scissor {
    /** True if the test is on; {@code null} if unknown. */
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
