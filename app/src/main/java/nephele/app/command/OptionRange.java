package nephele.app.command;

import java.lang.annotation.Annotation;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import java.lang.reflect.Field;
import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;

/**
 * The numbers that an option takes. They stand once, as an annotation of the option's field, which the check and its
 * message read; a test requires one of each numeric option.
 *
 * @param allowed the range in words
 * @param contains tells whether a word is a number in the range
 */
public record OptionRange(String allowed, Predicate<String> contains) {
    private static final String DECIMAL = "[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]{1,9})?";

    /** The range of an option with a whole number. */
    @Retention(RetentionPolicy.RUNTIME)
    @Target(ElementType.FIELD)
    public @interface Whole {
        /** The least number that is allowed. */
        long least();

        /** The greatest number that is allowed. */
        long most();
    }

    /** The range of an option with a decimal number. */
    @Retention(RetentionPolicy.RUNTIME)
    @Target(ElementType.FIELD)
    public @interface Decimal {
        /** The least number that is allowed. */
        double least();

        /** The greatest number that is allowed. */
        double most();

        /** The unit, for messages. */
        String unit();
    }

    /**
     * Returns the range of an option or parameter; empty if its field states none.
     *
     * @param argument null for none
     */
    static Optional<OptionRange> of(ArgSpec argument) {
        return argument != null && argument.userObject() instanceof Field field
                ? Stream.of(field.getAnnotations()).flatMap(OptionRange::stated).findFirst()
                : Optional.empty();
    }

    private static Stream<OptionRange> stated(Annotation annotation) {
        if (annotation instanceof Whole whole) {
            var words = "a whole number from " + whole.least() + " to " + whole.most();
            return Stream.of(new OptionRange(words, word -> isIn(whole, word)));
        }
        if (annotation instanceof Decimal decimal) {
            var words =
                    "a number of " + decimal.unit() + " from " + text(decimal.least()) + " to " + text(decimal.most());
            return Stream.of(new OptionRange(words, word -> isIn(decimal, word)));
        }
        return Stream.empty();
    }

    private static boolean isIn(Whole whole, String word) {
        try {
            long number = Long.parseLong(word);
            return number >= whole.least() && number <= whole.most();
        } catch (NumberFormatException noNumber) {
            return false;
        }
    }

    private static boolean isIn(Decimal decimal, String word) {
        double number = number(word);
        return number >= decimal.least() && number <= decimal.most();
    }

    /** Returns the value of a decimal number; NaN of any other word. */
    static double number(String word) {
        return word.matches(DECIMAL) ? Double.parseDouble(word) : Double.NaN;
    }

    /** Returns a number without an exponent. */
    static String text(double number) {
        return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
    }

    /** Throws a usage failure for the first word that is out of its option's range. */
    static void check(CommandLine commandLine, ParseResult parsed) {
        for (OptionSpec option : parsed.matchedOptions()) {
            List<String> words = option.originalStringValues();
            of(option).ifPresent(range -> words.stream()
                    .filter(range.contains.negate())
                    .findFirst()
                    .ifPresent(word -> {
                        throw new ParameterException(commandLine, range.refusal(option, word), option, word);
                    }));
        }
    }

    /** Returns the message about wrong usage: that of the range, if the word of an option with a range caused it. */
    static String message(ParameterException wrongUsage) {
        return wrongUsage.getArgSpec() instanceof OptionSpec option && wrongUsage.getValue() != null
                ? of(option)
                        .map(range -> range.refusal(option, wrongUsage.getValue()))
                        .orElse(wrongUsage.getMessage())
                : wrongUsage.getMessage();
    }

    private String refusal(OptionSpec option, String word) {
        return option.longestName() + " is " + allowed + ", not " + word;
    }
}
