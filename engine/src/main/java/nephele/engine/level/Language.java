package nephele.engine.level;

/** A language of the game; the lower-case name with a hyphen is its word in files. */
public enum Language {
    EN("English"),
    PT_BR("Português (Brasil)"),
    PT_PT("Português (Portugal)");

    private final String title;

    Language(String title) {
        this.title = title;
    }

    /** Returns the language's own name for itself. */
    public String title() {
        return title;
    }
}
