flat in vec4 added;

layout(location = 0) out vec4 bin;

void main() {
    bin = added;
}
