package nephele.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import nephele.engine.asset.FileName;
import org.lwjgl.system.JNI;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.system.linux.DynamicLinkLoader;

/**
 * Switches off Mesa's cache of compiled shaders where its disk is full. Mesa maps the cache's index into memory, as a file
 * with holes; the first write into a hole that the disk has no room for ends the process (SIGBUS).
 */
final class MesaCache {
    private static final String SWITCH = "MESA_SHADER_CACHE_DISABLE";

    /** Room for the index, 1.3 MB, with some for what others write meanwhile. */
    private static final long NEEDED_BYTES = 32 << 20;

    private MesaCache() {}

    /** Called before the first use of OpenGL; Mesa is used on Linux alone. */
    static void protect() {
        Map<String, String> environment = System.getenv();
        if (!System.getProperty("os.name").equals("Linux") || environment.containsKey(SWITCH)) {
            return;
        }
        if (places(environment, System.getProperty("user.home")).stream()
                .anyMatch(place -> !hasRoom(place, NEEDED_BYTES))) {
            switchOff();
        }
    }

    /** Returns where Mesa may keep its cache: where the environment says, else below the user's home. */
    static List<Path> places(Map<String, String> environment, String home) {
        List<String> named = Stream.of("MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR", "XDG_CACHE_HOME")
                .map(environment::get)
                .filter(Objects::nonNull)
                .toList();
        Stream<String> places = named.isEmpty()
                ? Stream.of(environment.get("HOME"), home)
                        .filter(Objects::nonNull)
                        .map(folder -> folder + "/.cache")
                : named.stream();
        return places.filter(place -> FileName.objection(place) == null)
                .map(Path::of)
                .distinct()
                .toList();
    }

    /** Returns true if the disk of a folder, which need not exist, has this much room, or if that is unknown. */
    static boolean hasRoom(Path folder, long bytes) {
        Path there = folder.toAbsolutePath();
        while (there != null && !Files.exists(there)) {
            there = there.getParent();
        }
        try {
            return there == null || Files.getFileStore(there).getUsableSpace() >= bytes;
        } catch (IOException | SecurityException unknown) {
            return true;
        }
    }

    /** Sets the variable for this process; Java itself can only read its environment. */
    private static void switchOff() {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            long functions = DynamicLinkLoader.dlopen((CharSequence) null, DynamicLinkLoader.RTLD_NOW);
            long setenv = DynamicLinkLoader.dlsym(functions, "setenv");
            if (setenv != MemoryUtil.NULL) {
                long name = MemoryUtil.memAddress(stack.ASCII(SWITCH));
                JNI.invokePPI(name, MemoryUtil.memAddress(stack.ASCII("true")), 1, setenv);
            }
        } catch (LinkageError noLibrary) {
            // Without LWJGL's library nothing will be drawn either; the drawing says why.
            return;
        }
    }
}
