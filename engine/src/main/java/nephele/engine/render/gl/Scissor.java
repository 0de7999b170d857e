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

    /** Divides the rectangle, if the test is on, for a layer of fewer pixels; two more on each side. */
    void divide(int divisor) {
        if (on == Boolean.TRUE) {
            int left = Math.max(0, x / divisor - 2);
            int low = Math.max(0, y / divisor - 2);
            keepTo(left, low, (x + width) / divisor + 3 - left, (y + height) / divisor + 3 - low);
        }
    }

    /** Returns a copy to which {@link #restore} goes back. */
    Scissor copy() {
        Scissor copy = new Scissor();
        copy.on = on;
        copy.x = x;
        copy.y = y;
        copy.width = width;
        copy.height = height;
        return copy;
    }

    void restore(Scissor before) {
        if (before.on == Boolean.TRUE) {
            keepTo(before.x, before.y, before.width, before.height);
        } else {
            off();
        }
    }

    void assumeNothing() {
        on = null;
        width = -1;
    }
}
