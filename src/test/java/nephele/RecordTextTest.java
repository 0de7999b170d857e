package nephele;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.thirdparty.org.objectweb.asm.ClassReader;
import com.tngtech.archunit.thirdparty.org.objectweb.asm.ClassVisitor;
import com.tngtech.archunit.thirdparty.org.objectweb.asm.Handle;
import com.tngtech.archunit.thirdparty.org.objectweb.asm.MethodVisitor;
import com.tngtech.archunit.thirdparty.org.objectweb.asm.Opcodes;
import com.tngtech.archunit.thirdparty.org.objectweb.asm.Type;
import java.io.IOException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * No text is made of a record as Java writes it, {@code Pinhole[eye=Vec3[x=…}: each place that puts a record into a text
 * has a record with a text of its own.
 */
class RecordTextTest {
    private int texts;
    private final Set<String> found = new TreeSet<>();

    @Test
    void noTextHoldsARecordAsJavaWritesIt() throws IOException {
        for (Class<?> module : List.of(
                nephele.app.Main.class,
                nephele.engine.level.Level.class,
                nephele.workshop.prove.Proofs.class,
                nephele.editor.document.Document.class)) {
            Path root = Path.of(
                    module.getProtectionDomain().getCodeSource().getLocation().getPath());
            if (Files.isDirectory(root)) {
                readAllBelow(root.resolve("nephele"));
            } else {
                try (FileSystem jar = FileSystems.newFileSystem(root)) {
                    readAllBelow(jar.getPath("/nephele"));
                }
            }
        }
        assertTrue(texts > 1000, texts + " texts were seen");
        assertEquals(Set.of(), found);
    }

    private void readAllBelow(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file :
                    files.filter(each -> each.toString().endsWith(".class")).toList()) {
                read(Files.readAllBytes(file));
            }
        }
    }

    private void read(byte[] bytes) {
        var reader = new ClassReader(bytes);
        String name = reader.getClassName();
        reader.accept(
                new ClassVisitor(Opcodes.ASM9) {
                    @Override
                    public MethodVisitor visitMethod(
                            int access, String method, String descriptor, String signature, String[] exceptions) {
                        return new Calls(name + "#" + method);
                    }
                },
                ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES);
    }

    /** Looks for concatenations and conversions to a text. */
    private final class Calls extends MethodVisitor {
        private final String place;

        private Calls(String place) {
            super(Opcodes.ASM9);
            this.place = place;
        }

        @Override
        public void visitInvokeDynamicInsn(String name, String descriptor, Handle bootstrap, Object... arguments) {
            if (bootstrap.getOwner().equals("java/lang/invoke/StringConcatFactory")) {
                texts++;
                for (Type part : Type.getArgumentTypes(descriptor)) {
                    see(part);
                }
            }
        }

        @Override
        public void visitMethodInsn(int opcode, String owner, String name, String descriptor, boolean isInterface) {
            if (name.equals("toString") && descriptor.equals("()Ljava/lang/String;") && !owner.startsWith("[")) {
                texts++;
                see(Type.getObjectType(owner));
            }
        }

        private void see(Type part) {
            if (part.getSort() == Type.OBJECT
                    && part.getClassName().startsWith("nephele.")
                    && isBare(part.getClassName())) {
                found.add(place + " " + part.getClassName());
            }
        }
    }

    private static boolean isBare(String className) {
        try {
            Class<?> type = Class.forName(className, false, RecordTextTest.class.getClassLoader());
            if (type.isRecord()) {
                return Stream.of(type.getDeclaredMethods())
                                .noneMatch(method -> method.getName().equals("toString"))
                        || isGenerated(type);
            }
            return type.isSealed() && Stream.of(type.getPermittedSubclasses()).anyMatch(each -> isBare(each.getName()));
        } catch (ClassNotFoundException impossible) {
            throw new AssertionError(impossible);
        }
    }

    /** Returns true if a record's toString is the compiler's. */
    private static boolean isGenerated(Class<?> type) {
        List<Boolean> generated = new ArrayList<>();
        try (var bytes = type.getResourceAsStream(type.getName().replaceAll(".*\\.", "") + ".class")) {
            new ClassReader(bytes)
                    .accept(
                            new ClassVisitor(Opcodes.ASM9) {
                                @Override
                                public MethodVisitor visitMethod(
                                        int access, String method, String descriptor, String sign, String[] thrown) {
                                    return !method.equals("toString")
                                            ? null
                                            : new MethodVisitor(Opcodes.ASM9) {
                                                @Override
                                                public void visitInvokeDynamicInsn(
                                                        String name, String shape, Handle by, Object... arguments) {
                                                    generated.add(
                                                            by.getOwner().equals("java/lang/runtime/ObjectMethods"));
                                                }
                                            };
                                }
                            },
                            0);
        } catch (IOException unreadable) {
            throw new AssertionError(unreadable);
        }
        return generated.contains(true);
    }
}
