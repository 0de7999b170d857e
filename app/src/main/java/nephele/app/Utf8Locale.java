package nephele.app;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.lwjgl.PointerBuffer;
import org.lwjgl.system.JNI;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.system.linux.DynamicLinkLoader;

/**
 * Starts the program again with UTF-8 where the locale has Java decode arguments and file names otherwise. Java does so
 * before any of our code runs, and under LC_ALL=C it loses each {@code é}, so only a new start mends it.
 */
final class Utf8Locale {
    /** Marks the second start; if that has no UTF-8 either, the system lacks the locale. */
    private static final String ENCODING = "LC_CTYPE=C.UTF-8";

    private Utf8Locale() {}

    /**
     * Replaces the process by one with the same arguments, on Linux. Returns if Java uses UTF-8 or the process can't be
     * replaced; names that the locale lacks are then refused where they are used.
     */
    static void require() {
        boolean isUtf8 = "UTF-8".equalsIgnoreCase(System.getProperty("sun.jnu.encoding"));
        if (isUtf8 || !System.getProperty("os.name").equals("Linux")) {
            return;
        }
        try {
            replace();
        } catch (IOException | LinkageError impossible) {
            return;
        }
    }

    private static void replace() throws IOException {
        Path self = Path.of("/proc/self");
        String arguments = bytes(self.resolve("cmdline"));
        String environment = bytes(self.resolve("environ"));
        // Names in another encoding than UTF-8 belong to a user for whose files the locale is right.
        if (environment.contains(ENCODING) || !isUtf8(arguments + environment)) {
            return;
        }
        List<String> variables = new ArrayList<>(List.of(environment.split("\0")));
        variables.removeIf(variable -> variable.startsWith("LC_ALL=") || variable.startsWith("LC_CTYPE="));
        variables.add(ENCODING);
        execute(self.resolve("exe").toRealPath().toString(), List.of(arguments.split("\0", -1)), variables);
    }

    /** Returns a file with each byte as a character. */
    private static String bytes(Path file) throws IOException {
        return new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
    }

    private static boolean isUtf8(String bytes) {
        try {
            StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes.getBytes(StandardCharsets.ISO_8859_1)));
            return true;
        } catch (CharacterCodingException otherEncoding) {
            return false;
        }
    }

    /** Calls POSIX execve, which returns only if it fails. */
    private static void execute(String program, List<String> arguments, List<String> environment) {
        long functions = DynamicLinkLoader.dlopen((CharSequence) null, DynamicLinkLoader.RTLD_NOW);
        long execve = DynamicLinkLoader.dlsym(functions, "execve");
        if (execve != MemoryUtil.NULL) {
            // The last argument ends with a zero, after which split gives an empty text.
            PointerBuffer words = strings(arguments.subList(0, arguments.size() - 1));
            PointerBuffer variables = strings(environment);
            JNI.callPPPI(MemoryUtil.memAddress(string(program)), words.address(), variables.address(), execve);
        }
    }

    /** Returns a C array of strings that ends with a null. It stays allocated: the process ends or is replaced. */
    private static PointerBuffer strings(List<String> texts) {
        PointerBuffer pointers = MemoryUtil.memAllocPointer(texts.size() + 1);
        texts.forEach(text -> pointers.put(string(text)));
        return pointers.put(MemoryUtil.NULL).flip();
    }

    private static ByteBuffer string(String bytes) {
        byte[] text = bytes.getBytes(StandardCharsets.ISO_8859_1);
        return MemoryUtil.memAlloc(text.length + 1).put(text).put((byte) 0).flip();
    }
}
