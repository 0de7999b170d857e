package nephele.engine.render.gl;

/**
 * Thrown on a machine without the required OpenGL; the message states what is required, what was found and how to get
 * it.
 */
public final class GlUnavailableException extends RuntimeException {
    public GlUnavailableException(String message) {
        super(message);
    }
}
