package nephele.engine.atmosphere;

import java.util.Optional;

/** Where light fields are kept that took seconds to compute. A field that is not found is computed again. */
public interface AirFiles {
    /** Keeps nothing. */
    AirFiles NONE = new AirFiles() {
        @Override
        public Optional<byte[]> find(String name) {
            return Optional.empty();
        }

        @Override
        public void store(String name, byte[] bytes) {}
    };

    /** Returns the content of a file; empty if there is none. */
    Optional<byte[]> find(String name);

    /** Keeps a file if possible. */
    void store(String name, byte[] bytes);
}
