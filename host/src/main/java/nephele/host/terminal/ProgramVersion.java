package nephele.host.terminal;

/** Tells which program this is: the version, and the commit that its jar was built from with its date. */
public final class ProgramVersion {
    private ProgramVersion() {}

    /** Returns for example {@code 0.14 (50e79ea5ab, 2026-11-28)}; classes outside a jar have no version. */
    public static String text() {
        String version = ProgramVersion.class.getPackage().getImplementationVersion();
        return version == null ? "(from classes, without a version)" : version;
    }

    /** Returns the program with the machine's Java and system, in a line. */
    public static String line() {
        return "nephele " + text() + ", Java " + System.getProperty("java.version") + ", "
                + System.getProperty("os.name") + " " + System.getProperty("os.arch");
    }
}
