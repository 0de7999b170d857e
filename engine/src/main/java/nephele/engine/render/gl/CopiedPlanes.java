package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** The components of each pixel that are copied between targets. */
public enum CopiedPlanes {
    COLOUR(GL_COLOR_BUFFER_BIT),
    DEPTH(GL_DEPTH_BUFFER_BIT),
    COLOUR_AND_DEPTH(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    final int buffers;

    CopiedPlanes(int buffers) {
        this.buffers = buffers;
    }
}
