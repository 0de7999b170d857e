package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL11C.glEnable;
import static org.lwjgl.opengl.KHRDebug.*;

import org.lwjgl.opengl.GLDebugMessageCallback;

/** Forwards the driver's serious messages to standard error, if the driver has them. */
final class DebugMessages implements AutoCloseable {
    /** Property that enables the messages; they cost start-up time and synchronise every call. */
    private static final String PROPERTY = "nephele.gl.debug";

    private final GLDebugMessageCallback callback;

    private DebugMessages(GLDebugMessageCallback callback) {
        this.callback = callback;
    }

    static DebugMessages listen(GpuLimits limits) {
        if (!limits.debugMessages() || !Boolean.getBoolean(PROPERTY)) {
            return new DebugMessages(null);
        }
        GLDebugMessageCallback callback =
                GLDebugMessageCallback.create((source, type, id, severity, length, message, user) -> {
                    if (severity == GL_DEBUG_SEVERITY_HIGH || type == GL_DEBUG_TYPE_ERROR) {
                        System.err.println("OpenGL: " + GLDebugMessageCallback.getMessage(length, message));
                    }
                });
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(callback, 0);
        return new DebugMessages(callback);
    }

    @Override
    public void close() {
        if (callback != null) {
            glDebugMessageCallback(null, 0);
            callback.free();
        }
    }
}
