package nephele.app.command;

/** The version of the program and of the machine's Java, in a line. */
final class Version {
    private Version() {}

    /** Returns the jar's version; classes outside a jar have none. */
    static String line() {
        String version = Version.class.getPackage().getImplementationVersion();
        return "nephele " + (version == null ? "(from classes, without a version)" : version) + ", Java "
                + System.getProperty("java.version") + ", " + System.getProperty("os.name") + " "
                + System.getProperty("os.arch");
    }
}
