package nephele.editor.document;

/** A listener's registration; closing it ends the listening, closing it again does nothing. */
@FunctionalInterface
public interface Registration extends AutoCloseable {
    @Override
    void close();
}
