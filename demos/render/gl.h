// OpenGL, as OSMesa has it. OSMesa comes with a whole compiler, whose loading takes longer than the start of everything
// else here, so a program that draws nothing does without it: these are pointers, which LoadOsMesa() (off_screen.h)
// sets.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

namespace dgd_demos {

/// Every function of OpenGL and of OSMesa that the demos call.
#define DGD_GL_FUNCTIONS(USE)   \
  USE(OSMesaCreateContextExt)   \
  USE(OSMesaDestroyContext)     \
  USE(OSMesaMakeCurrent)        \
  USE(glAttachShader)           \
  USE(glBegin)                  \
  USE(glBindFramebuffer)        \
  USE(glBindTexture)            \
  USE(glCallList)               \
  USE(glCheckFramebufferStatus) \
  USE(glClear)                  \
  USE(glClearColor)             \
  USE(glColor3d)                \
  USE(glCompileShader)          \
  USE(glCreateProgram)          \
  USE(glCreateShader)           \
  USE(glCullFace)               \
  USE(glDeleteShader)           \
  USE(glDisable)                \
  USE(glDrawBuffer)             \
  USE(glEnable)                 \
  USE(glEnd)                    \
  USE(glEndList)                \
  USE(glFinish)                 \
  USE(glFramebufferTexture2D)   \
  USE(glGenFramebuffers)        \
  USE(glGenLists)               \
  USE(glGenTextures)            \
  USE(glGetProgramiv)           \
  USE(glGetShaderInfoLog)       \
  USE(glGetShaderiv)            \
  USE(glGetUniformLocation)     \
  USE(glLinkProgram)            \
  USE(glLoadIdentity)           \
  USE(glMatrixMode)             \
  USE(glNewList)                \
  USE(glNormal3fv)              \
  USE(glOrtho)                  \
  USE(glReadBuffer)             \
  USE(glShaderSource)           \
  USE(glTexImage2D)             \
  USE(glTexParameterfv)         \
  USE(glTexParameteri)          \
  USE(glUniform1f)              \
  USE(glUniform1i)              \
  USE(glUniform3fv)             \
  USE(glUniformMatrix4fv)       \
  USE(glUseProgram)             \
  USE(glVertex2d)               \
  USE(glVertex3fv)              \
  USE(glViewport)

// In this namespace, their names stand for the pointers.
#define DGD_DECLARE_GL_FUNCTION(name) extern decltype(&::name) name;
DGD_GL_FUNCTIONS(DGD_DECLARE_GL_FUNCTION)
#undef DGD_DECLARE_GL_FUNCTION

}  // namespace dgd_demos
