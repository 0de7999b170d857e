package nephele.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.lang.conditions.ArchPredicates.are;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.methods;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import java.util.List;
import java.util.regex.Pattern;

/** The rules for compiled classes; {@link DeterminismRules} and {@link SourceRules} hold the others. */
final class CodeRules {
    private static final Pattern BANNED_NAME =
            Pattern.compile("Abstract.*|.*(Manager|Helper|Utils?|Info|Impl|Handler|Data)");

    static final List<ArchRule> ALL = List.of(
            classes()
                    .that()
                    .resideInAnyPackage("nephele.engine..", "nephele.scenes..")
                    .should(PackageTable.useOnlyWhatTheTableAllows())
                    .as("packages of engine and scenes use only what PackageTable allows"),
            classes()
                    .that()
                    .resideInAPackage("nephele.engine.render.pass..")
                    .should(PackageTable.useNoOtherPass())
                    .as("a pass uses no other pass"),
            classes()
                    .that()
                    .resideInAPackage("nephele..")
                    .should(PackageTable.useOnlyModulesOfTheTable())
                    .as("a module uses only those that PackageTable allows"),
            noClasses()
                    .that()
                    .resideInAPackage("nephele.app..")
                    .and()
                    .resideOutsideOfPackage("nephele.app.command..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage("nephele.lab..")
                    .as("of app only commands use the lab"),
            noClasses()
                    .that()
                    .resideInAPackage("nephele.app..")
                    .and()
                    .resideOutsideOfPackages("nephele.app.command..", "nephele.app.view..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage("nephele.scenes..")
                    .as("of app only commands and the viewer's window use XML scenes"),
            slices().assignedFrom(PackageTable.slices())
                    .should()
                    .beFreeOfCycles()
                    .as("no cycles between packages"),
            classes()
                    .that()
                    .areTopLevelClasses()
                    .and(are(describe("written", CodeRules::isWritten)))
                    .should(PackageSize.atMost35Classes())
                    .as("no package with more than 60 classes"),
            classes()
                    .that()
                    .areTopLevelClasses()
                    .and(are(describe("written", CodeRules::isWritten)))
                    .should(PackageSize.aNameOfItsOwn())
                    .as("no simple name twice"),
            noClasses()
                    .that()
                    .resideInAnyPackage("nephele.engine..", "nephele.scenes.xml..")
                    .and()
                    .resideOutsideOfPackages("nephele.engine.render..", "nephele.engine.asset..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAnyPackage("org.lwjgl..", "java.awt..", "javax.swing..", "javax.imageio..")
                    .as("headless packages see neither LWJGL nor AWT"),
            noClasses()
                    .that()
                    .resideInAPackage("nephele.engine.asset..")
                    .should()
                    .dependOnClassesThat(describe(
                            "LWJGL but stb, or AWT but images and colours",
                            type -> isBeyondDecoding(type.getPackageName())))
                    .as("asset sees of LWJGL and AWT only what decodes images"),
            noClasses()
                    .that()
                    .resideInAPackage("nephele.engine..")
                    .and()
                    .doNotHaveSimpleName("ColourProfile")
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage("java.awt.color..")
                    .as("colour profiles are used in one class"),
            noClasses()
                    .that()
                    .resideInAnyPackage("nephele.engine.render..", "nephele.scenes..")
                    .should()
                    .dependOnClassesThat(describe("AWT but images, or Swing", type -> type.getPackageName()
                            .matches("javax\\.swing.*|java\\.awt(?!\\.image).*")))
                    .as("the renderer opens no window of its own"),
            noClasses()
                    .that()
                    .resideOutsideOfPackage("nephele.engine.render.gl..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAnyPackage("org.lwjgl.opengl", "org.lwjgl.egl..")
                    .as("raw OpenGL only in render.gl"),
            noClasses()
                    .that()
                    .resideInAPackage("nephele.editor.tool..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAnyPackage("javax.swing..", "java.awt..")
                    .as("editor tools know no Swing"),
            methods()
                    .that(are(describe("readers of files", CodeRules::isReader)))
                    .should(refuseTheWindowsThread())
                    .as("readers refuse the thread of a window"),
            fields().should(beFinalWhenStatic()).as("no mutable statics"),
            classes()
                    .that(are(describe("named", type -> !type.isAnonymousClass())))
                    .should(haveATellingName())
                    .as("no names that say nothing"),
            classes().should(inheritNothingOfOurs()).as("no inheritance beyond interface and class"),
            methods().should(takeAtMostOneBoolean()).as("no pairs of boolean parameters"));

    private CodeRules() {}

    /** A reader makes a value of ours from the name and the bytes of a file. */
    private static boolean isReader(JavaMethod method) {
        List<JavaClass> given = method.getRawParameterTypes();
        return method.getOwner().getPackageName().matches("nephele\\.engine\\.(asset|model\\.file)")
                && method.getModifiers().containsAll(List.of(JavaModifier.PUBLIC, JavaModifier.STATIC))
                && given.size() >= 2
                && given.get(0).isEquivalentTo(String.class)
                && given.get(1).isEquivalentTo(byte[].class)
                && method.getRawReturnType().getPackageName().startsWith("nephele.");
    }

    /** Its first act may be to call another reader. */
    private static ArchCondition<JavaMethod> refuseTheWindowsThread() {
        return new ArchCondition<>("refuse the thread of a window") {
            @Override
            public void check(JavaMethod method, ConditionEvents events) {
                boolean refuses = method.getMethodCallsFromSelf().stream()
                        .anyMatch(call -> call.getTarget().getFullName().contains(".SwingThread.refuse(")
                                || call.getTargetOwner().equals(method.getOwner())
                                        && call.getName().equals(method.getName()));
                if (!refuses) {
                    events.add(SimpleConditionEvent.violated(method, method.getFullName() + " reads on any thread"));
                }
            }
        };
    }

    private static boolean isWritten(JavaClass type) {
        return !type.getSimpleName().equals("package-info");
    }

    private static boolean isBeyondDecoding(String packageName) {
        boolean lwjgl = packageName.startsWith("org.lwjgl.") && !packageName.matches("org\\.lwjgl\\.(stb|system)");
        return lwjgl || packageName.matches("javax\\.swing.*|java\\.awt(?!\\.image|\\.color).*");
    }

    private static ArchCondition<JavaField> beFinalWhenStatic() {
        return new ArchCondition<>("be final when static") {
            @Override
            public void check(JavaField field, ConditionEvents events) {
                boolean isStatic = field.getModifiers().contains(JavaModifier.STATIC);
                boolean isFinal = field.getModifiers().contains(JavaModifier.FINAL);
                events.add(new SimpleConditionEvent(field, !isStatic || isFinal, field.getFullName() + " is mutable"));
            }
        };
    }

    private static ArchCondition<JavaClass> haveATellingName() {
        return new ArchCondition<>("have a name that is a term of the field") {
            @Override
            public void check(JavaClass type, ConditionEvents events) {
                boolean banned = BANNED_NAME.matcher(type.getSimpleName()).matches();
                events.add(new SimpleConditionEvent(type, !banned, type.getName() + " has a banned suffix"));
            }
        };
    }

    /** Permits only superclasses from libraries (Swing, exceptions, callbacks), and our enums with constant bodies. */
    private static ArchCondition<JavaClass> inheritNothingOfOurs() {
        return new ArchCondition<>("extend no class of ours") {
            @Override
            public void check(JavaClass type, ConditionEvents events) {
                type.getRawSuperclass().ifPresent(parent -> {
                    boolean fine = parent.getName().matches("java\\.lang\\.(Object|Record|Enum)")
                            || parent.isAssignableTo(Throwable.class)
                            || parent.isEnum()
                            || parent.getPackageName().matches("javax\\.swing.*|java\\.awt.*")
                            || isCallBack(parent);
                    events.add(new SimpleConditionEvent(type, fine, type.getName() + " extends " + parent.getName()));
                });
            }
        };
    }

    /** Returns true for library types that are meant to be extended and have no interface instead. */
    private static boolean isCallBack(JavaClass parent) {
        return parent.getPackageName().startsWith("org.lwjgl")
                || parent.getPackageName().startsWith("javax.imageio")
                || parent.getName().matches("java\\.io\\.(Filter)?(In|Out)putStream|java\\.lang\\.Class(Loader|Value)");
    }

    private static ArchCondition<JavaMethod> takeAtMostOneBoolean() {
        return new ArchCondition<>("take at most one boolean") {
            @Override
            public void check(JavaMethod method, ConditionEvents events) {
                long booleans = method.getRawParameterTypes().stream()
                        .filter(type -> type.getName().equals("boolean"))
                        .count();
                // The signatures of Swing's cell renderers are not ours.
                boolean written = !method.getName().matches(".*\\$.*|get(List|Table|Tree)CellRendererComponent");
                events.add(new SimpleConditionEvent(
                        method, !written || booleans < 2, method.getFullName() + " takes " + booleans + " booleans"));
            }
        };
    }
}
