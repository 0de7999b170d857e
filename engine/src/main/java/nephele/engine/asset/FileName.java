package nephele.engine.asset;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.stream.Stream;

/** The names of files as users type them. */
public final class FileName {
    private FileName() {}

    /** Returns the reason why no file here can have a name, with what to do, or {@code null} if one can. */
    public static String objection(String typed) {
        try {
            Path.of(typed);
            return null;
        } catch (InvalidPathException noPath) {
            boolean isAscii = typed.chars().allMatch(c -> c < 0x80);
            return isAscii
                    ? "this is no file name on this system; choose another"
                    : "the locale " + locale() + " has no such characters in file names; set LC_ALL=C.UTF-8 and start"
                            + " Nephele again";
        }
    }

    /** Returns a name as text for a message: characters that could control a terminal are replaced. */
    public static String printable(String typed) {
        return MessageText.shortened(MessageText.printable(typed));
    }

    private static String locale() {
        return Stream.of("LC_ALL", "LC_CTYPE", "LANG")
                .map(System::getenv)
                .filter(Objects::nonNull)
                .filter(value -> !value.isEmpty())
                .findFirst()
                .orElse("C");
    }
}
