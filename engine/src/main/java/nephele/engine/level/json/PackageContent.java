package nephele.engine.level.json;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Enumeration;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.MessageText;
import nephele.engine.level.Level;

/**
 * The content of a package, checked and in memory: a .zip whose only .json at the top is a level, and whose other entries
 * are its assets.
 *
 * @param levelName the entry of the level
 * @param assets all entries by their names
 */
public record PackageContent(String levelName, Level level, AssetSource assets) {
    public static final int MOST_ENTRIES = 2_000;
    public static final int MOST_ENTRY_BYTES = 128 << 20;

    /** Bounds memory: entries are counted as they are unpacked, whatever size they declare. */
    static final int MOST_BYTES = 512 << 20;

    /** Thrown for a file that is no package, or one with an unsafe or damaged entry. */
    public static final class Refused extends RuntimeException {
        private static final long serialVersionUID = 1;

        private final String entry;

        private Refused(String entry, String reason, Throwable cause) {
            super(reason, cause);
            this.entry = entry;
        }

        /** Returns the entry at fault as text for messages; empty if it is the file as a whole. */
        public Optional<String> entry() {
            return Optional.ofNullable(entry);
        }
    }

    /** Returns true for the name of a package. */
    public static boolean isPackage(String file) {
        return file.toLowerCase(Locale.ROOT).endsWith(".zip");
    }

    /**
     * Reads a package.
     *
     * @throws Refused if it is none, or has an unsafe or damaged entry
     */
    public static PackageContent read(Path zip) {
        Map<String, byte[]> entries;
        try (var file = new ZipFile(zip.toFile())) {
            entries = entries(file);
        } catch (ZipException | IllegalArgumentException noZip) {
            throw new Refused(null, "it is no whole zip file", noZip);
        } catch (IOException unreadable) {
            throw new Refused(null, AtomicFile.reason(unreadable), unreadable);
        }
        var levels = entries.keySet().stream()
                .filter(name -> !name.contains("/") && name.endsWith(".json"))
                .toList();
        if (levels.size() != 1) {
            String reason = levels.isEmpty() ? "it holds no level" : "it holds several levels: " + levels;
            throw new Refused(null, reason, null);
        }
        String name = levels.get(0);
        try {
            return new PackageContent(name, LevelJson.read(name, entries.get(name)), new Entries(entries));
        } catch (LevelFormatException noLevel) {
            throw new Refused(name, noLevel.getMessage().lines().findFirst().orElse(""), noLevel);
        }
    }

    private static Map<String, byte[]> entries(ZipFile file) throws IOException {
        if (file.size() > MOST_ENTRIES) {
            throw new IOException("it has more than " + MOST_ENTRIES + " entries");
        }
        Map<String, byte[]> entries = new LinkedHashMap<>();
        Set<String> lowerCase = new HashSet<>();
        long total = 0;
        for (Enumeration<? extends ZipEntry> all = file.entries(); all.hasMoreElements(); ) {
            ZipEntry entry = all.nextElement();
            check(entry.getName(), lowerCase);
            if (!entry.isDirectory()) {
                byte[] content = content(file, entry, (int) Math.min(MOST_ENTRY_BYTES, MOST_BYTES - total));
                entries.put(entry.getName(), content);
                total += content.length;
            }
        }
        return entries;
    }

    private static void check(String name, Set<String> lowerCase) {
        String id = name.endsWith("/") ? name.substring(0, name.length() - 1) : name;
        String objection = AssetId.rejectionReason(id);
        if (objection == null && !lowerCase.add(name.toLowerCase(Locale.ROOT))) {
            objection = "another entry has the same name on systems that ignore case";
        }
        if (objection != null) {
            throw refused(name, objection);
        }
    }

    private static byte[] content(ZipFile file, ZipEntry entry, int most) {
        try (InputStream stream = file.getInputStream(entry)) {
            byte[] content = stream.readNBytes(most + 1);
            if (content.length > most) {
                throw refused(
                        entry.getName(),
                        "it has more than " + (MOST_ENTRY_BYTES >> 20) + " MiB, or all entries together more than "
                                + (MOST_BYTES >> 20) + " MiB");
            }
            return content;
        } catch (IOException damaged) {
            throw refused(entry.getName(), "it is damaged");
        } catch (OutOfMemoryError tooLarge) {
            throw refused(entry.getName(), "it does not fit into memory");
        }
    }

    private static Refused refused(String name, String reason) {
        String printable = MessageText.printable(name);
        String start = printable.length() > 100 ? printable.substring(0, 100) + "…" : printable;
        return new Refused(start, reason, null);
    }

    /** The entries as assets. */
    private record Entries(Map<String, byte[]> content) implements AssetSource {
        @Override
        public boolean exists(String assetId) {
            return content.containsKey(assetId);
        }

        @Override
        public byte[] bytes(String assetId) {
            byte[] bytes = content.get(assetId);
            if (bytes == null) {
                throw new AssetException(assetId, "is not in the package", "export it again");
            }
            return bytes;
        }
    }
}
