package nephele.engine.render.gl;

/** The machine cannot give the OpenGL that is needed; the message says required, found and how to get it. */
public final class GlUnavailableException extends RuntimeException {
    public GlUnavailableException(String message) {
        super(message);
    }
}
