package nephele.engine.render.gl;

import java.util.function.IntConsumer;
import nephele.engine.render.gl.shader.GlException;

/** One OpenGL name with one owner; closing twice is an error of the owner and throws. */
final class GlHandle implements AutoCloseable {
    private final GlContext gl;
    private final GlKind kind;
    private final String name;
    private final IntConsumer delete;
    private int id;

    GlHandle(GlContext gl, GlKind kind, String name, int id, IntConsumer delete) {
        if (id == 0) {
            throw new GlException(name + ": OpenGL gave no " + kind + " name");
        }
        this.gl = gl;
        this.kind = kind;
        this.name = name;
        this.delete = delete;
        this.id = id;
        gl.live().opened(kind);
    }

    int id() {
        if (id == 0) {
            throw new GlException(name + ": used after close");
        }
        return id;
    }

    String name() {
        return name;
    }

    @Override
    public void close() {
        delete.accept(id());
        gl.live().closed(kind);
        gl.bindings().forget(kind, id);
        id = 0;
    }
}
