package nephele.editor.play;

import java.util.List;
import java.util.Map;

/** The options by which the waiting game keeps little memory. */
public final class GameMemory {
    /**
     * Options of the Java virtual machine: a small young generation, as a frame allocates next to nothing, and a heap
     * that is given back after a play, as is what the C library has freed (Java 17.0.9 and later). The first of the two compilers is enough for a game whose first seconds count:
     * with both, the first frame of level 01 costs 2.6 s of processor time instead of 1.7 s, and 20 MB more.
     */
    public static final List<String> JAVA_OPTIONS = List.of(
            "-XX:+UseSerialGC",
            "-Xms16m",
            "-Xmn8m",
            "-XX:MinHeapFreeRatio=5",
            "-XX:MaxHeapFreeRatio=10",
            "-XX:-ShrinkHeapInSteps",
            "-XX:TieredStopAtLevel=1",
            "-XX:+IgnoreUnrecognizedVMOptions",
            "-XX:TrimNativeHeapInterval=3000");

    private GameMemory() {}

    /** Sets what the C library keeps: few arenas for llvmpipe's many threads, and freed pictures return to the system. */
    static void limit(Map<String, String> environment) {
        environment.putIfAbsent("MALLOC_ARENA_MAX", "2");
        environment.putIfAbsent("MALLOC_TRIM_THRESHOLD_", "131072");
        environment.putIfAbsent("MALLOC_MMAP_THRESHOLD_", "131072");
    }
}
