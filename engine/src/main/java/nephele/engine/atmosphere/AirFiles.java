package nephele.engine.atmosphere;

import java.util.Map;
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

    /** Returns files in memory, with a map of their bytes by name. */
    static AirFiles in(Map<String, byte[]> kept) {
        return new AirFiles() {
            @Override
            public Optional<byte[]> find(String name) {
                return Optional.ofNullable(kept.get(name));
            }

            @Override
            public void store(String name, byte[] bytes) {
                kept.put(name, bytes);
            }
        };
    }
}
